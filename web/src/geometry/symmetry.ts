/** Axes of symmetry of a shape, through the middle of its bounding box. */
import type { Box } from './box';
import type { Vec } from './vec';

/** The vertical axis at `x` and the horizontal axis at `y`; null without one. */
export interface Symmetry {
  readonly x: number | null;
  readonly y: number | null;
}

/** Places along each side of the box that are compared with their mirror images. */
const PLACES = 48;

/** The least share of the shape that its mirror image covers. Drawn figures are not exactly symmetric. */
const ALIKE = 0.94;

/** @param contains whether a place lies in the shape. Asked for a lattice of places. */
export function symmetryOf({ min, max }: Box, contains: (at: Vec) => boolean): Symmetry {
  const along = (axis: 0 | 1, k: number) => min[axis] + ((k + 0.5) / PLACES) * (max[axis] - min[axis]);
  const rows = Array.from({ length: PLACES }, (_, row) =>
    Array.from({ length: PLACES }, (_, column) => contains([along(0, column), along(1, row)])),
  );
  const at = (row: number, column: number) => rows[row]?.[column] === true;
  const isAlike = (image: (row: number, column: number) => boolean): boolean => {
    let [both, either] = [0, 0];
    for (let row = 0; row < PLACES; row++)
      for (let column = 0; column < PLACES; column++) {
        const [here, there] = [at(row, column), image(row, column)];
        if (here && there) both++;
        if (here || there) either++;
      }
    return either > 0 && both >= ALIKE * either;
  };
  const middle = (axis: 0 | 1) => (min[axis] + max[axis]) / 2;
  return {
    x: isAlike((row, column) => at(row, PLACES - 1 - column)) ? middle(0) : null,
    y: isAlike((row, column) => at(PLACES - 1 - row, column)) ? middle(1) : null,
  };
}
