import type { Vec } from '../geometry/vec';
import type { Words } from '../texts/wording';
import type { Corner } from './corner';
import type { Focus } from './focus';

/** The open context menu. */
export interface MenuState {
  readonly name: Words;
  /** The selected handles, or the picture. */
  readonly about: 'handles' | 'picture';
  /** Of the handles, the one corner that was pressed. */
  readonly corner: Corner | null;
  /** The pressed place, image pixels, and whether it can hold a point handle. */
  readonly at: Vec;
  readonly bends: boolean;
  /** The selection when the menu opened. It closes when the selection changes. */
  readonly selection: readonly string[];
  /** The focus once the menu has closed. */
  readonly focus: Focus;
}
