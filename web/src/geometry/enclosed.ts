/**
 * The inside of closed lines, as rings that touch neither themselves nor one another.
 *
 * A place is inside if the lines wind around it, any number of times. So a figure eight has two rings, and a line that
 * goes around twice, or makes a small loop at a turn, loses nothing. A middle that lines leave out is a hole.
 *
 * Lines are cut where they cross or touch, and edges that go to and fro cancel. An edge is a border if the lines wind
 * around only one of its sides. Rings that would share a corner there are moved apart.
 *
 * Cost: quadratic in corners and crossings.
 */
import { areaOf, isSimple, type Ring, signedAreaOf, TOUCH } from './ring';
import { add, cross, distance, lerp, midpoint, rotated, scaled, subtract, type Vec } from './vec';

/** How far a corner that several rings share is moved into each, image pixels. */
const APART = 0.1;

/** Cuts make new places, which may lie on other edges. Two or three passes are usual. */
const MOST_PASSES = 20;

/** The ends of an edge, as indices of places. */
type Edge = readonly [from: number, to: number];

/** @param least smaller rings are left out, but not the largest one. */
export function enclosedBy(lines: readonly Ring[], least = 0): readonly Ring[] {
  const all = ringsOf(lines);
  const most = Math.max(...all.map(areaOf));
  const kept = movedApart(all.filter((ring) => areaOf(ring) >= Math.min(least, most)));
  // Moved corners may close narrower places.
  return kept.map((ring) => (isSimple(ring) ? ring : largestOf(ringsOf([ring])))).filter(isSimple);
}

/** The rings, which may share corners. */
function ringsOf(lines: readonly Ring[]): readonly Ring[] {
  const { places, edges } = cutLines(lines);
  return tracedRings(bordersOf(places, edges), places);
}

const largestOf = (rings: readonly Ring[]): Ring =>
  rings.reduce((best, ring) => (areaOf(ring) > areaOf(best) ? ring : best), []);

/** The largest part inside a ring that touches itself; otherwise the ring itself. */
export const simpleRing = (drawn: Ring): Ring =>
  isSimple(drawn) ? drawn : (enclosedBy([drawn], Number.POSITIVE_INFINITY)[0] ?? []);

/** The outer boundary of two rings that overlap. Gaps that the two enclose are filled. */
export const unionOf = (a: Ring, b: Ring): Ring =>
  enclosedBy([clockwise(a), clockwise(b)], Number.POSITIVE_INFINITY)[0] ?? [];

const clockwise = (ring: Ring): Ring => (signedAreaOf(ring) < 0 ? ring.toReversed() : ring);

/** The lines as edges that meet only at their ends. */
function cutLines(lines: readonly Ring[]): { places: readonly Vec[]; edges: readonly Edge[] } {
  const places: Vec[] = [];
  const place = (at: Vec): number => {
    const known = places.findIndex((other) => distance(other, at) < TOUCH);
    return known >= 0 ? known : places.push(at) - 1;
  };
  const at = (index: number): Vec => places[index] ?? [0, 0];
  let edges: readonly Edge[] = lines.flatMap((line) => {
    const corners = line.map(place);
    return corners.map((from, k): Edge => [from, corners[(k + 1) % corners.length] ?? from]);
  });
  for (let pass = 0; pass < MOST_PASSES; pass++) {
    const before = edges.length;
    edges = edges.flatMap((edge) => cutAtPlaces(edge, places)).filter(([from, to]) => from !== to);
    const known = places.length;
    edges.forEach(([a, b], k) => {
      for (let other = k + 1; other < edges.length; other++) {
        const [c, d] = edges[other] ?? [a, b];
        if (a === c || a === d || b === c || b === d) continue;
        const crossing = crossingOf(at(a), at(b), at(c), at(d));
        if (crossing) place(crossing);
      }
    });
    if (pass > 0 && edges.length === before && places.length === known) break;
  }
  return { places, edges };
}

/** An edge in pieces between the places that it passes. */
function cutAtPlaces([from, to]: Edge, places: readonly Vec[]): readonly Edge[] {
  const [a, b] = [places[from], places[to]];
  if (!a || !b) return [];
  const [low, high] = [
    [Math.min(a[0], b[0]) - TOUCH, Math.min(a[1], b[1]) - TOUCH],
    [Math.max(a[0], b[0]) + TOUCH, Math.max(a[1], b[1]) + TOUCH],
  ] as const;
  const along = subtract(b, a);
  const length = Math.hypot(...along);
  const passed: [fraction: number, place: number][] = [];
  places.forEach((p, k) => {
    if (k === from || k === to || p[0] < low[0] || p[1] < low[1] || p[0] > high[0] || p[1] > high[1]) return;
    const by = subtract(p, a);
    const fraction = (by[0] * along[0] + by[1] * along[1]) / (length * length);
    if (fraction > 0 && fraction < 1 && Math.abs(cross(along, by)) / length < TOUCH)
      passed.push([fraction, k]);
  });
  const stops = [from, ...passed.sort(([s], [t]) => s - t).map(([, k]) => k), to];
  return stops.slice(1).map((stop, k): Edge => [stops[k] ?? stop, stop]);
}

/** Where two edges cross between their ends. */
function crossingOf(a: Vec, b: Vec, c: Vec, d: Vec): Vec | null {
  for (const axis of [0, 1] as const)
    if (
      Math.max(a[axis], b[axis]) < Math.min(c[axis], d[axis]) ||
      Math.max(c[axis], d[axis]) < Math.min(a[axis], b[axis])
    )
      return null;
  const [one, other, gap] = [subtract(b, a), subtract(d, c), subtract(c, a)];
  const area = cross(one, other);
  const [s, t] = [cross(gap, other) / area, cross(gap, one) / area];
  return s > 0 && s < 1 && t > 0 && t < 1 ? lerp(a, b, s) : null;
}

/** The edges with the inside of the lines only on their right side. */
function bordersOf(places: readonly Vec[], edges: readonly Edge[]): readonly Edge[] {
  const times = new Map<number, number>();
  for (const [from, to] of edges) {
    const key = Math.min(from, to) * places.length + Math.max(from, to);
    times.set(key, (times.get(key) ?? 0) + (from < to ? 1 : -1));
  }
  const all = [...times].flatMap(([key, count]) => {
    const edge: Edge = [Math.floor(key / places.length), key % places.length];
    const [a, b] = [places[edge[0]], places[edge[1]]];
    return a && b && count !== 0 ? { edge, a, b, count } : [];
  });
  return all.flatMap((one) => {
    const { edge, a, b, count } = one;
    const middle = midpoint(a, b);
    // Along a ray to the right, and a little down.
    const windings = all.reduce(
      (sum, other) => (other === one ? sum : sum + other.count * passes(other.a, other.b, middle)),
      0,
    );
    const isAhead = b[1] < a[1] || (b[1] === a[1] && b[0] > a[0]);
    const [right, left] = isAhead ? [windings, windings - count] : [windings + count, windings];
    if ((right === 0) === (left === 0)) return [];
    return [right !== 0 ? edge : ([edge[1], edge[0]] as const)];
  });
}

/** Whether an edge passes the ray to the right of a place: 1 downwards, −1 upwards. */
function passes(a: Vec, b: Vec, [x, y]: Vec): number {
  if (a[1] <= y === b[1] <= y) return 0;
  const at = a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0]);
  return at > x ? (a[1] <= y ? 1 : -1) : 0;
}

/** Walks along borders, at each place around the inside that is beside the border before. */
function tracedRings(borders: readonly Edge[], places: readonly Vec[]): readonly Ring[] {
  const at = (index: number): Vec => places[index] ?? [0, 0];
  const ways = new Map<number, number[]>();
  for (const [from, to] of borders) ways.set(from, [...(ways.get(from) ?? []), to]);
  const rings: Ring[] = [];
  for (const [start, left] of ways)
    for (let first = left.pop(); first !== undefined; first = left.pop()) {
      const ring = [start];
      let [behind, here]: [number, number] = [start, first];
      for (;;) {
        const back = subtract(at(behind), at(here));
        const turn = (to: number) => turnFrom(back, subtract(at(to), at(here)));
        const ahead: readonly number[] = [...(ways.get(here) ?? []), ...(here === start ? [first] : [])];
        const next: number = ahead.reduce(
          (best, to) => (turn(to) > turn(best) ? to : best),
          ahead[0] ?? start,
        );
        if (ahead.length === 0 || (here === start && next === first)) break;
        ring.push(here);
        ways.get(here)?.splice(ahead.indexOf(next), 1);
        [behind, here] = [here, next];
      }
      rings.push(ring.map(at));
    }
  return rings;
}

/** Moves corners that rings share, or one ring has twice, into each ring. */
function movedApart(rings: readonly Ring[]): readonly Ring[] {
  const times = new Map<Vec, number>();
  for (const corner of rings.flat()) times.set(corner, (times.get(corner) ?? 0) + 1);
  return rings.map((ring) =>
    ring.map((at, k) => {
      if (times.get(at) === 1) return at;
      const [back, ahead] = [
        subtract(ring.at(k - 1) ?? at, at),
        subtract(ring[(k + 1) % ring.length] ?? at, at),
      ];
      const [length, shorter] = [Math.hypot(...back), Math.min(Math.hypot(...back), Math.hypot(...ahead))];
      const half = 180 - turnFrom(back, ahead) / 2;
      // Farther into a narrow corner, so that it keeps away from both sides.
      const by = Math.min(
        APART / Math.sin((Math.min(half, 90) * Math.PI) / 180),
        Math.max(APART, shorter / 3),
      );
      return add(at, rotated(scaled(back, by / length), -half));
    }),
  );
}

/** The turn from one direction to another in degrees, clockwise, above 0 and at most a whole turn. */
function turnFrom(from: Vec, to: Vec): number {
  const turn = (Math.atan2(cross(from, to), from[0] * to[0] + from[1] * to[1]) * 180) / Math.PI;
  return turn > 1e-9 ? turn : turn + 360;
}
