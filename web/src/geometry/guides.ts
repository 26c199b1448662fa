/** Guides: lines along the axes that a moved place snaps to. Image pixels. */
import { snapped, type Vec } from './vec';

export interface Guide {
  /** 0: the vertical line at x = `at`. 1: the horizontal line at y = `at`. */
  readonly axis: 0 | 1;
  readonly at: number;
}

/** The lines in question, and the distance between the lines of a grid. */
export interface Guides {
  readonly lines: readonly Guide[];
  readonly grid: number;
}

/** A place, and the guides that it lies on. */
export interface SnappedPlace {
  readonly at: Vec;
  readonly guides: readonly Guide[];
}

/** The minimum distance between lines of the grid, CSS pixels. Most places lie between them, and move freely. */
const GRID_CSS_PX = 64;

/** Returns the distance between lines of the grid: 1, 2 or 5 times a power of ten. @param scale CSS px per image px. */
export function gridStep(scale: number): number {
  const least = GRID_CSS_PX / scale;
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5].find((factor) => factor * power >= least) ?? 10);
}

/**
 * Snaps a position to the nearest line within reach, along each axis separately. Snaps to the grid where no line is
 * within reach.
 */
export function snappedTo(place: Vec, { lines, grid }: Guides, reach: number): SnappedPlace {
  const guides = ([0, 1] as const).flatMap((axis) => {
    const away = ({ at }: Guide) => Math.abs(at - place[axis]);
    const own = lines.filter((line) => line.axis === axis && away(line) <= reach);
    const [line = { axis, at: snapped(place[axis], grid) }] = own.sort((a, b) => away(a) - away(b));
    return away(line) <= reach ? [line] : [];
  });
  const along = (axis: 0 | 1) => guides.find((guide) => guide.axis === axis)?.at ?? place[axis];
  return { at: [along(0), along(1)], guides };
}
