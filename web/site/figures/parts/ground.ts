/** The shape of the picture: the points that figures ask about, and the triangles between them. */
import type { Point, Solution } from '../../../src/core';
import { isInsideOf } from '../../../src/geometry/ring';
import { PixelMap } from './pixel_map';

/** The part of the way to the middle of the triangles around a point: a hundredth of a pixel. */
const DRAWN_IN = 0.002;

export class Ground {
  /** A solution without handles, for distances. */
  readonly solution: Solution;
  /** Points × 2, in pixels of the picture: the samples of the shape, slightly inside the outline. */
  readonly points: Float64Array<ArrayBuffer>;
  /** Triangles × 3 points. */
  readonly triangles: Uint32Array;
  /** The outline, to be drawn and clipped to. */
  readonly path: Path2D;
  readonly #rings: readonly (readonly Point[])[];
  /** Of the boards' present size, which they share. */
  #pixels: PixelMap | undefined;

  constructor(solution: Solution, rings: readonly (readonly Point[])[]) {
    const { mesh, report } = solution;
    this.solution = solution;
    this.triangles = inside(mesh.triangles, report.samples);
    this.points = drawnIn(mesh.positions.subarray(0, 2 * report.samples), this.triangles);
    this.path = pathOf(rings);
    this.#rings = rings;
  }

  /** The triangle under each pixel of a board. @param scale Pixels of the board a pixel of the picture. */
  pixels(width: number, height: number, scale: number): PixelMap {
    const known = this.#pixels;
    if (known?.width === width && known.height === height) return known;
    this.#pixels = new PixelMap(this.points, this.triangles, width, height, scale);
    return this.#pixels;
  }

  /** A point itself if it is inside the shape, otherwise the nearest of the points. */
  nearest([x, y]: Point): Point {
    if (isInsideOf(this.#rings, [x, y])) return [x, y];
    let [best, least] = [0, Number.POSITIVE_INFINITY];
    for (let at = 0; at < this.points.length; at += 2) {
      const distance = Math.hypot((this.points[at] ?? 0) - x, (this.points[at + 1] ?? 0) - y);
      if (distance < least) [best, least] = [at, distance];
    }
    return this.point(best / 2);
  }

  point(index: number): Point {
    return [this.points[2 * index] ?? 0, this.points[2 * index + 1] ?? 0];
  }
}

/** The triangles between samples: those of the skirt around the shape are left out. */
const inside = (triangles: Uint32Array, samples: number): Uint32Array =>
  triangles.filter((_, at) => {
    const first = at - (at % 3);
    return triangles.subarray(first, first + 3).every((vertex) => vertex < samples);
  });

/**
 * Moves points towards the middle of the triangles around them, which changes only those of the outline. Positions are
 * rounded to 32 bits, so points of the outline may lie outside by that.
 */
function drawnIn(positions: Float32Array, triangles: Uint32Array): Float64Array<ArrayBuffer> {
  const sums = new Float64Array(positions.length);
  const counts = new Uint32Array(positions.length);
  for (let at = 0; at < triangles.length; at++) {
    const vertex = triangles[at] as number;
    const first = at - (at % 3);
    for (const corner of triangles.subarray(first, first + 3)) {
      for (const axis of [0, 1]) {
        sums[2 * vertex + axis] = (sums[2 * vertex + axis] ?? 0) + (positions[2 * corner + axis] ?? 0);
        counts[2 * vertex + axis] = (counts[2 * vertex + axis] ?? 0) + 1;
      }
    }
  }
  return Float64Array.from(positions, (position, at) => {
    const middle = (sums[at] as number) / (counts[at] as number);
    return position + DRAWN_IN * (middle - position);
  });
}

function pathOf(rings: readonly (readonly Point[])[]): Path2D {
  const path = new Path2D();
  for (const ring of rings) {
    for (const [x, y] of ring) path.lineTo(x, y);
    path.closePath();
  }
  return path;
}
