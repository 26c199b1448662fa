/** A place where the posed picture is turned over. */
import type { Box } from './box';

export interface Crease {
  /** The box around it, image pixels. */
  readonly box: Box;
  /** The area that is turned over, square image pixels. */
  readonly area: number;
}
