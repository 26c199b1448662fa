/** A clip of a rig: the motions of its sites, and the drawing order, at any time. */
import type { Bytes } from './bytes';

/** Numbers of a stored motion: angle, strain xx, xy and yy, translation x and y. */
export const NUMBERS = 6;
/** Numbers of a motion for the vertex shader: three texels. */
export const STRIDE = 12;

/** Behaviour at the end. 0: the clip stops. 1: it repeats. 2: it runs backwards. */
const ALTERNATE = 2;

export interface Order {
  readonly frame: number;
  /** Whether parts cross. */
  readonly crosses: boolean;
  /** Indices of triangles; null for the order of the mesh. */
  readonly triangles: Uint32Array | null;
}

export interface RigClip {
  /** Empty for a pose. */
  readonly name: string;
  /** Seconds; 0 for a pose. */
  readonly duration: number;
  readonly end: number;
  readonly lastFrame: number;
  /** Frames, ascending from 0 to the last. */
  readonly keys: Uint32Array;
  /** Keys × sites × 6. */
  readonly motions: Float64Array;
  readonly orders: readonly Order[];
}

/** Seconds until the clip repeats: forwards and backwards for a clip that alternates. */
export const cycleOf = ({ duration, end }: RigClip): number => (end === ALTERNATE ? 2 : 1) * duration;

/** The frame at a time within the cycle. */
export function frameAt({ duration, lastFrame }: RigClip, time: number): number {
  if (duration === 0) return 0;
  const within = time > duration ? 2 * duration - time : time;
  return Math.min(lastFrame, Math.max(0, (within / duration) * lastFrame));
}

export const orderAt = ({ orders }: RigClip, frame: number): Order =>
  orders.findLast((order) => order.frame <= frame) ?? (orders[0] as Order);

/** A number of a site's motion: angle, strain xx, xy and yy, translation x and y. */
export type MotionNumber = (site: number, index: number) => number;

/** The motions at a frame. */
export function motionAt({ keys, motions }: RigClip, sites: number, frame: number): MotionNumber {
  let after = keys.findIndex((key) => key > frame);
  if (after < 0) after = keys.length - 1;
  const before = Math.max(0, after - 1);
  const [start, end] = [keys[before] ?? 0, keys[after] ?? 0];
  const along = end > start ? Math.min(1, (frame - start) / (end - start)) : 0;
  return (site, index) => {
    const a = motions[(before * sites + site) * NUMBERS + index] ?? 0;
    const b = motions[(after * sites + site) * NUMBERS + index] ?? 0;
    return a + along * (b - a);
  };
}

/** The motions at a frame, sites × 6. */
export function motionsAt(clip: RigClip, sites: number, frame: number): Float64Array {
  const motion = motionAt(clip, sites, frame);
  return Float64Array.from({ length: sites * NUMBERS }, (_, at) =>
    motion(Math.floor(at / NUMBERS), at % NUMBERS),
  );
}

/**
 * Writes the motions at a frame for the vertex shader, sites × 12.
 *
 * @param rest Sites × 2.
 */
export function writeMotions(clip: RigClip, rest: Float64Array, frame: number, to: Float32Array): void {
  const sites = rest.length / 2;
  const motion = motionAt(clip, sites, frame);
  for (let site = 0; site < sites; site++) {
    const number = (index: number) => motion(site, index);
    const angle = number(0);
    const [x, y] = [rest[2 * site] ?? 0, rest[2 * site + 1] ?? 0];
    to.set(
      [
        ...linearOf([angle, number(1), number(2), number(3)]),
        x,
        y,
        x + number(4),
        y + number(5),
        0,
        angle,
        Math.cos(angle / 2),
        Math.sin(angle / 2),
      ],
      STRIDE * site,
    );
  }
}

/** R(angle) exp(strain) as [a, b, c, d]: x goes to (a, b), y to (c, d). Takes angle, strain xx, xy and yy. */
export function linearOf([angle = 0, xx = 0, xy = 0, yy = 0]: readonly number[]): readonly number[] {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  // The exponential of the strain: e^mean (cosh r + sinh r / r · [half xy; xy −half]).
  const half = (xx - yy) / 2;
  const r = Math.hypot(half, xy);
  const scale = Math.exp((xx + yy) / 2);
  const even = scale * Math.cosh(r);
  const odd = scale * (r === 0 ? 1 : Math.sinh(r) / r);
  const [p, q, s] = [even + odd * half, odd * xy, even - odd * half];
  return [cos * p - sin * q, sin * p + cos * q, cos * q - sin * s, sin * q + cos * s];
}

export function readClip(from: Bytes, sites: number, triangles: number): RigClip {
  const name = from.text();
  const duration = from.float();
  const end = from.byte();
  from.check(end <= ALTERNATE, 'has an unknown loop mode');
  const lastFrame = from.varint();
  from.check(lastFrame <= 2 ** 16, 'has too many frames');
  const fits = lastFrame === 0 ? duration === 0 : duration > 0 && duration < Number.POSITIVE_INFINITY;
  from.check(fits, 'has a duration that does not match its frames');
  const count = from.count();
  from.check(count > 0, 'has no motions');
  let frame = 0;
  const keys = Uint32Array.from({ length: count }, (_, key) => {
    if (key === 0) return 0;
    const step = from.varint();
    frame += step;
    from.check(step > 0 && frame <= lastFrame, 'has keys out of order');
    return frame;
  });
  from.check(frame === lastFrame, 'has no motions at its end');
  const [angle, strain, place] = [from.byte(), from.byte(), from.byte()];
  from.check(Math.max(angle, strain, place) <= 24, 'has motions with too many bits');
  from.check(from.has(count * sites * NUMBERS), 'ends too early');
  const motions = new Float64Array(count * sites * NUMBERS);
  [angle, strain, strain, strain, place, place].forEach((bits, number) => {
    for (let site = 0; site < sites; site++) {
      let steps = 0;
      for (let key = 0; key < count; key++) {
        steps = (steps + from.signed()) | 0;
        motions[(key * sites + site) * NUMBERS + number] = steps / 2 ** bits;
      }
    }
  });
  return { name, duration, end, lastFrame, keys, motions, orders: readOrders(from, lastFrame, triangles) };
}

function readOrders(from: Bytes, lastFrame: number, triangles: number): Order[] {
  let frame = 0;
  const count = from.count(2);
  from.check(count > 0, 'has no drawing order');
  let before: Uint32Array | null = null;
  return Array.from({ length: count }, (_, index) => {
    const step = from.varint();
    frame += step;
    from.check(step > 0 === index > 0 && frame <= lastFrame, 'has unsorted drawing orders');
    const flags = from.byte();
    // The order of the mesh, its own one, or the one before.
    from.check(flags < 4 || (flags < 6 && index > 0), 'has an unknown kind of drawing order');
    if (flags < 4) before = flags < 2 ? null : readOrder(from, triangles);
    return { frame, crosses: (flags & 1) > 0, triangles: before };
  });
}

function readOrder(from: Bytes, count: number): Uint32Array {
  from.check(count > 0 && from.has(count), 'ends too early');
  const drawn = new Uint8Array(count);
  let next = 0;
  return Uint32Array.from({ length: count }, () => {
    const triangle = (next + from.signed()) | 0;
    from.check(drawn[triangle] === 0, 'has an invalid drawing order');
    drawn[triangle] = 1;
    next = triangle + 1;
    return triangle;
  });
}
