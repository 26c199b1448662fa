import type { RingCorner } from '../document/lasso_corners';
import type { Corner } from './corner';

/** The focus inside the editor. */
export interface Focus {
  readonly on: 'nothing' | 'stage' | 'handle' | 'corner' | 'ring' | 'key' | 'field' | 'control';
  /** The handle of a focused handle or corner. */
  readonly handle: string | null;
  /** The last focused corner, until a handle or the stage has the focus. The panel's corner fields edit it. */
  readonly corner: Corner | null;
  /** The focused corner of the selection's outline. */
  readonly ring: RingCorner | null;
}
