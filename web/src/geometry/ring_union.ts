/**
 * The union of two rings, by a walk along its outer boundary. Gaps that the two enclose are filled.
 *
 * Cost: the product of their corners. Neither ring may touch itself. Corners of one that lie exactly on the other are
 * taken for crossings or passed by.
 */
import type { Ring } from './ring';
import { cross, distance, lerp, subtract, type Vec } from './vec';

/** A corner of either ring, or a crossing of both. */
interface Junction {
  readonly at: Vec;
  readonly ways: Junction[];
}

/** The outer boundary of two rings that overlap. Of rings apart, the one that reaches farther to the left. */
export function unionOf(a: Ring, b: Ring): Ring {
  const onA = a.map((): [number, Junction][] => []);
  const onB = b.map((): [number, Junction][] => []);
  a.forEach((from, i) => {
    const to = a[(i + 1) % a.length] ?? from;
    b.forEach((start, j) => {
      const end = b[(j + 1) % b.length] ?? start;
      const [along, other, gap] = [subtract(to, from), subtract(end, start), subtract(start, from)];
      const area = cross(along, other);
      const [s, t] = [cross(gap, other) / area, cross(gap, along) / area];
      if (!(s > 0 && s < 1 && t > 0 && t < 1)) return;
      const junction: Junction = { at: lerp(from, to, s), ways: [] };
      onA[i]?.push([s, junction]);
      onB[j]?.push([t, junction]);
    });
  });
  const junctions = [...linked(a, onA), ...linked(b, onB)];
  const [start] = junctions.sort((one, other) => one.at[0] - other.at[0] || one.at[1] - other.at[1]);
  return start ? walked(start, junctions.length) : [];
}

/** The junctions along a ring, each linked to the next. */
function linked(ring: Ring, crossings: readonly (readonly [number, Junction])[][]): readonly Junction[] {
  const all = ring.flatMap((at, k) => [
    { at, ways: [] },
    ...(crossings[k] ?? []).toSorted(([s], [t]) => s - t).map(([, junction]) => junction),
  ]);
  all.forEach((junction, k) => {
    const next = all[(k + 1) % all.length] ?? junction;
    junction.ways.push(next);
    next.ways.push(junction);
  });
  return all;
}

/** Walks from the leftmost junction along the outside, at each junction by the first way beside the one behind. */
function walked(start: Junction, most: number): Ring {
  const ring: Vec[] = [];
  let [here, behind]: [Junction, Vec] = [start, [start.at[0] - 1, start.at[1]]];
  do {
    ring.push(here.at);
    const back = subtract(behind, here.at);
    const turn = ({ at }: Junction) => turnFrom(back, subtract(at, here.at));
    const next = here.ways.reduce((best, way) => (turn(way) < turn(best) ? way : best));
    [here, behind] = [next, here.at];
  } while (here !== start && ring.length <= 2 * most);
  return ring;
}

/** The turn from one direction to another in radians, above 0 and at most a whole turn. */
function turnFrom(from: Vec, to: Vec): number {
  const turn = Math.atan2(cross(from, to), from[0] * to[0] + from[1] * to[1]);
  return turn > 1e-12 ? turn : turn + 2 * Math.PI;
}

/** Corners of half a circle. */
const HALF = 8;

/** All places nearer than `radius` to a straight line, as a ring. */
export function capsule(from: Vec, to: Vec, radius: number): Ring {
  const length = distance(from, to);
  const [x, y] = length > 0 ? [(to[0] - from[0]) / length, (to[1] - from[1]) / length] : [1, 0];
  const half = (centre: Vec, sign: number): Ring =>
    Array.from({ length: HALF + 1 }, (_, k) => {
      const angle = Math.PI * (k / HALF - 0.5);
      const [along, aside] = [sign * radius * Math.cos(angle), sign * radius * Math.sin(angle)];
      return [centre[0] + along * x - aside * y, centre[1] + along * y + aside * x] as const;
    });
  return [...half(to, 1), ...half(from, -1)];
}
