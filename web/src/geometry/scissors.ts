/**
 * Intelligent scissors: the path between two places that follows the edges of a picture (Mortensen and Barrett 1995).
 *
 * Dijkstra's algorithm finds the cheapest path in a window around both places, where steep luminance is cheap. Costs
 * are whole numbers, so that a ring of buckets sorts the nodes. Without edges the path is straight. It continues an
 * outline, whose edges are not used again.
 *
 * Cost: linear in the nodes of the window, of which there are at most {@link MOST_NODES}.
 */
import { type EdgeWindow, edgeWindow, LEAST_STEEPNESS } from './edge_cost';
import type { Luminance } from './luminance';
import { distanceToLine, edgesOf } from './polyline';
import { simplified } from './polyline_simplified';
import { add, distance, scaled, subtract, type Vec } from './vec';

/** The most nodes of a window: some 3 ms. A larger window has coarser nodes. */
export const MOST_NODES = 14_000;

/** Room around both places for detours, as a fraction of their distance, and at least so many image pixels per node. */
const DETOUR = 0.4;
const LEAST_ROOM = 12;

/** The cost of a step without an edge, and the least one. The largest step is one across a corner. */
const FLAT = 240;
const LEAST = 12;
const DIAGONAL = Math.SQRT2;
const BUCKETS = 512;

/** The length of the pieces of a precise path, in numbers of the luminance. */
const PIECE = 60;

/** Paths lose corners within these distances, in nodes as fine as the luminance and in coarser ones. */
const TOLERANCE = { fine: 1.2, coarse: 0.9 } as const;

/** In nodes: the distance that a path keeps from the existing outline. Edges closer than this belong to the outline. */
const CLEARANCE = 1.5;
const OWN_EDGE = 3;

/** A path leaves the ends of an outline at 30° to it, or more. The sine of that. */
const LEAVING = 0.5;

/** A window around a path that is sought, and the nodes that it cannot pass: 1, or 0. */
interface Search extends EdgeWindow {
  readonly from: Vec;
  readonly to: Vec;
  readonly barred: Uint8Array<ArrayBuffer>;
}

/**
 * The path along edges from the end of an outline to a place: without its start, and with its end. It uses no part of
 * the outline again. If no other way is left, it is straight.
 */
export const edgePath = (luminance: Luminance, outline: readonly Vec[], to: Vec): readonly Vec[] =>
  pathIn(luminance, searchAround(luminance, outline, to));

/**
 * The same path, as precise as the luminance. A long path is found on coarse nodes first, and then piece by piece.
 *
 * Cost: some 3 ms for each piece.
 */
export function finePath(luminance: Luminance, outline: readonly Vec[], to: Vec): readonly Vec[] {
  const search = searchAround(luminance, outline, to);
  const { pitch } = search;
  if (pitch <= luminance.step) return pathIn(luminance, search);
  const each = Math.max(1, Math.round((PIECE * luminance.step) / pitch));
  const places = placesIn(search).filter((_, k, all) => k > 0 && k < all.length - 1 && k % each === 0);
  let line = outline;
  for (const place of [...places, to]) {
    const stop = place === to ? to : edgeNear(luminance, place, 1.5 * pitch, line);
    line = [...line, ...pathIn(luminance, searchAround(luminance, line, stop, 2 * pitch))];
  }
  return line.slice(outline.length);
}

/** The search for a path from the end of an outline. @param room by default as much as a detour takes. */
function searchAround(luminance: Luminance, outline: readonly Vec[], to: Vec, room?: number): Search {
  const from = outline.at(-1) ?? to;
  const around = room ?? Math.max(DETOUR * distance(from, to), LEAST_ROOM * luminance.step);
  const [low, high] = [
    [Math.min(from[0], to[0]) - around, Math.min(from[1], to[1]) - around],
    [Math.max(from[0], to[0]) + around, Math.max(from[1], to[1]) + around],
  ] as const;
  const window = edgeWindow(luminance, low, high, MOST_NODES);
  return { ...window, from, to, barred: clearedOf(window, outline, [from, to]) };
}

/** Takes the edges of an outline out of a window. Returns the nodes at the outline, except beyond some ends of it. */
function clearedOf(
  window: EdgeWindow,
  outline: readonly Vec[],
  ends: readonly Vec[],
): Uint8Array<ArrayBuffer> {
  const { width, height, steepness } = window;
  const inNodes = (at: Vec): Vec => add(scaled(subtract(at, window.origin), 1 / window.pitch), [-0.5, -0.5]);
  const away = new Float32Array(width * height).fill(OWN_EDGE);
  const corners = outline.map(inNodes);
  for (const [a, b] of edgesOf(corners, false)) {
    const span = (axis: 0 | 1, count: number) => [
      Math.max(0, Math.ceil(Math.min(a[axis], b[axis]) - OWN_EDGE)),
      Math.min(count - 1, Math.floor(Math.max(a[axis], b[axis]) + OWN_EDGE)),
    ];
    const [[left = 0, right = 0], [top = 0, bottom = 0]] = [span(0, width), span(1, height)];
    for (let y = top; y <= bottom; y++)
      for (let x = left; x <= right; x++) {
        const node = y * width + x;
        away[node] = Math.min(away[node] ?? 0, distanceToLine([a, b], false, [x, y]));
      }
  }
  const barred = new Uint8Array(width * height);
  const beyond = ends.map(inNodes);
  away.forEach((near, node) => {
    const at: Vec = [node % width, Math.floor(node / width)];
    if (near >= OWN_EDGE || beyond.some((end) => near >= LEAVING * distance(at, end))) return;
    steepness[node] = 0;
    if (near < CLEARANCE) barred[node] = 1;
  });
  return barred;
}

function pathIn({ step }: Luminance, search: Search): readonly Vec[] {
  const tolerance = search.pitch > step ? TOLERANCE.coarse : TOLERANCE.fine;
  return simplified(placesIn(search), tolerance * search.pitch).slice(1);
}

/** The places of the cheapest path that lie on clear edges, and both ends. Between them it is straight. */
function placesIn(search: Search): readonly Vec[] {
  const { from, to, steepness } = search;
  const clear = cheapestPath(search)
    .slice(1, -1)
    .filter((node) => (steepness[node] ?? 0) >= LEAST_STEEPNESS);
  return [from, ...clear.map((node) => placeOf(search, node)), to];
}

/**
 * The clearest edge within a distance of a place; the place itself if none is clear.
 *
 * @param outline lies on edges that do not count.
 */
export function edgeNear(luminance: Luminance, at: Vec, radius: number, outline: readonly Vec[] = []): Vec {
  const margin = radius + 3 * luminance.step;
  const window = edgeWindow(luminance, add(at, [-margin, -margin]), add(at, [margin, margin]), MOST_NODES);
  clearedOf(window, outline, []);
  let [best, most]: [Vec, number] = [at, LEAST_STEEPNESS];
  window.steepness.forEach((steep, node) => {
    const place = placeOf(window, node);
    const away = distance(place, at);
    // Of two edges, a nearer one counts up to twice as much.
    const counts = steep * (1 - away / (2 * radius));
    if (away <= radius && counts > most) [best, most] = [place, counts];
  });
  return best;
}

const placeOf = ({ width, origin, pitch }: EdgeWindow, node: number): Vec =>
  add(origin, scaled([(node % width) + 0.5, Math.floor(node / width) + 0.5], pitch));

function nodeAt({ width, height, origin, pitch }: EdgeWindow, at: Vec): number {
  const [x, y] = scaled(subtract(at, origin), 1 / pitch);
  const within = (value: number, count: number) => Math.min(count - 1, Math.max(0, Math.floor(value)));
  return within(y, height) * width + within(x, width);
}

/** The cost of a step onto each node: by its steepness and, a little, by its distance from the straight line. */
function stepCosts({ width, steepness }: EdgeWindow, from: number, to: number): Uint16Array {
  let most = 2 * LEAST_STEEPNESS;
  for (const steep of steepness) most = Math.max(most, steep);
  // Half of the steepest is steep enough: one hard edge must not hide the others.
  const enough = Math.max(2 * LEAST_STEEPNESS, most / 2);
  const [x0, y0] = [from % width, Math.floor(from / width)];
  const [dx, dy] = [(to % width) - x0, Math.floor(to / width) - y0];
  const length = Math.max(1, Math.hypot(dx, dy));
  const costs = new Uint16Array(steepness.length);
  for (let node = 0; node < costs.length; node++) {
    const flat = Math.max(0, 1 - (steepness[node] ?? 0) / enough);
    const aside =
      Math.abs(dx * (Math.floor(node / width) - y0) - dy * ((node % width) - x0)) / (length * length);
    costs[node] = LEAST + FLAT * flat * flat + Math.min(80, 48 * aside);
  }
  return costs;
}

/** The nodes of the cheapest path, including both ends. If no path connects them, only the ends. */
function cheapestPath(search: Search): readonly number[] {
  const { width, height } = search;
  const [from, to] = [nodeAt(search, search.from), nodeAt(search, search.to)];
  const costs = stepCosts(search, from, to);
  const total = new Int32Array(width * height).fill(-1);
  const before = new Int32Array(width * height).fill(-1);
  const done = search.barred.slice();
  done[from] = 0;
  done[to] = 0;
  const buckets: number[][] = Array.from({ length: BUCKETS }, () => []);
  total[from] = 0;
  buckets[0]?.push(from);
  let waiting = 1;
  for (let now = 0; waiting > 0; now++) {
    const bucket = buckets[now % BUCKETS] ?? [];
    for (let node = bucket.pop(); node !== undefined; node = bucket.pop()) {
      waiting--;
      if (done[node] === 1) continue;
      done[node] = 1;
      if (node === to) return pathTo(to, before);
      const x = node % width;
      for (let dy = -width; dy <= width; dy += width) {
        const row = node + dy - x;
        if (row < 0 || row >= width * height) continue;
        for (let dx = -1; dx <= 1; dx++) {
          const next = node + dy + dx;
          if (x + dx < 0 || x + dx >= width || done[next] === 1) continue;
          const cost = now + Math.round((costs[next] ?? 0) * (dx !== 0 && dy !== 0 ? DIAGONAL : 1));
          const known = total[next] ?? -1;
          if (known >= 0 && known <= cost) continue;
          total[next] = cost;
          before[next] = node;
          buckets[cost % BUCKETS]?.push(next);
          waiting++;
        }
      }
    }
  }
  return [from, to];
}

function pathTo(to: number, before: Int32Array): readonly number[] {
  const path: number[] = [];
  for (let node = to; node >= 0; node = before[node] ?? -1) path.push(node);
  return path.reverse();
}
