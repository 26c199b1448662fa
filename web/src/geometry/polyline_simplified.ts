/** Simplification of lines (Douglas and Peucker 1973). Cost: linear in the corners for each corner that is kept. */
import { distanceToLine } from './polyline';
import { distance, subtract, type Vec } from './vec';

/** Drops corners of an open line, so that each lies within `tolerance` of the rest. The ends stay. */
export function simplified(line: readonly Vec[], tolerance: number): readonly Vec[] {
  const kept = new Set([0, line.length - 1]);
  const spans: [number, number][] = [[0, line.length - 1]];
  for (let span = spans.pop(); span; span = spans.pop()) {
    const [from, to] = span;
    const [start, end] = [line[from], line[to]];
    if (!start || !end) continue;
    let [farthest, most] = [-1, tolerance];
    for (let k = from + 1; k < to; k++) {
      const away = distanceToLine([start, end], false, line[k] ?? start);
      if (away > most) [farthest, most] = [k, away];
    }
    if (farthest < 0) continue;
    kept.add(farthest);
    spans.push([from, farthest], [farthest, to]);
  }
  return line.filter((_, k) => kept.has(k));
}

/** Cosine of the widest angle of a whisker, 30°. */
const SHARP = 0.87;

/**
 * Drops the tips of whiskers from a ring: corners at which it turns back, with a side shorter than `length`.
 *
 * @param kept corners of the ring that stay in any case.
 */
export function withoutWhiskers(
  ring: readonly Vec[],
  length: number,
  kept: ReadonlySet<Vec | undefined> = new Set(),
): readonly Vec[] {
  for (let left = ring; ; ) {
    const tip = left.findIndex(
      (at, k) => !kept.has(at) && isTip(left.at(k - 1) ?? at, at, left[(k + 1) % left.length] ?? at, length),
    );
    if (tip < 0 || left.length <= 3) return left;
    left = left.filter((_, k) => k !== tip);
  }
}

function isTip(before: Vec, at: Vec, after: Vec, length: number): boolean {
  const [a, b] = [subtract(before, at), subtract(after, at)];
  const [long, other] = [distance(before, at), distance(after, at)];
  return Math.min(long, other) < length && a[0] * b[0] + a[1] * b[1] >= SHARP * long * other;
}
