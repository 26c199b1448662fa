/**
 * The motions of all sites for posed handles, in the harmonic mode: sums of the motions of handles and bones.
 *
 * wasm/core/src/rig/sources.rs and shares.rs are the same in Rust.
 */
import { linearOf, NUMBERS } from './clip';
import type { Anchor, Bone, Handle, Place, Shares } from './shares';

/** The map of a source: it moves `anchor` to `posed`, and rotates and stretches around it. */
interface Source {
  readonly anchor: Place;
  readonly posed: Place;
  /** From the anchor along the bone, to its end. */
  readonly bone: Place;
  readonly depth: number;
  /** Angle, strain xx, xy and yy. */
  readonly numbers: readonly number[];
  /** The motion passed to virtual sites. */
  readonly passedOn: readonly number[];
}

/** A bone posed to a length below this, in pixels, has no direction. */
const NO_LENGTH = 1e-9;
/** Least stretch, and least ratio of the stretches. */
const MIN_STRETCH = 1e-9;
const MIN_RATIO = 0.1;
const TURN = 2 * Math.PI;

/** Automatic rotations need the solver. */
const radians = (rotation: number | 'auto') => (rotation === 'auto' ? 0 : (rotation * Math.PI) / 180);
const minus = ([ax, ay]: Place, [bx, by]: Place): Place => [ax - bx, ay - by];
const between = ([ax, ay]: Place, [bx, by]: Place, fraction: number): Place => [
  ax + fraction * (bx - ax),
  ay + fraction * (by - ay),
];
const dot = ([ax, ay]: Place, [bx, by]: Place) => ax * bx + ay * by;
const cross = ([ax, ay]: Place, [bx, by]: Place) => ax * by - ay * bx;
const mean = (places: readonly Place[]): Place => [
  places.reduce((sum, [x]) => sum + x, 0) / places.length,
  places.reduce((sum, [, y]) => sum + y, 0) / places.length,
];

const segmentOf = (corners: readonly Place[], segment: number): [Place, Place] => [
  corners[segment] as Place,
  corners[(segment + 1) % corners.length] as Place,
];

/** A strain whose smaller stretch is at least a tenth of the greater one, unless both exceed 1. */
function passedOn(numbers: readonly number[]): readonly number[] {
  const [angle, xx, xy, yy] = numbers as [number, number, number, number];
  const [middle, half] = [(xx + yy) / 2, (xx - yy) / 2];
  const r = Math.hypot(half, xy);
  const least = Math.min(0, middle + r + Math.log(MIN_RATIO));
  if (middle - r >= least || r === 0) return numbers;
  const [center, excess] = [(middle + r + least) / 2, (middle + r - least) / (2 * r)];
  return [angle, center + excess * half, excess * xy, center - excess * half];
}

function pointSource({ rest, posed, rotation, scale, depth }: Handle): Source {
  const stretch = Math.log(scale);
  const numbers = [radians(rotation), stretch, 0, stretch];
  return {
    anchor: rest[0] as Place,
    posed: posed[0] as Place,
    bone: [0, 0],
    depth,
    numbers,
    passedOn: numbers,
  };
}

function boneSource(bone: Bone, handles: readonly Handle[], joints: readonly Place[]): Source {
  const handle = handles[bone.handle] as Handle;
  const [a, b] = bone.rest;
  const along = minus(...(segmentOf(handle.posed, bone.segment).reverse() as [Place, Place]));
  const length = Math.hypot(...along);
  const side = length > 0 ? handle.scale / length : 0;
  const [c, d] = [0, 1].map((end): Place => {
    const [x, y] = joints[bone.joints[end] as number] as Place;
    const [beyond, beside] = [bone.beyond[end] as number, side * (bone.beside[end] as number)];
    return [x + beyond * along[0] - beside * along[1], y + beyond * along[1] + beside * along[0]];
  }) as [Place, Place];
  const before = minus(b, a);
  const after = minus(d, c);
  const stretched = Math.hypot(...after);
  const whole = radians(handle.rotation);
  const angle = Math.atan2(cross(before, after), dot(before, after));
  const hasLength = stretched >= NO_LENGTH;
  const log = (stretch: number) => Math.log(Math.max(MIN_STRETCH, stretch));
  const across = log(handle.scale);
  const excess = log(hasLength ? stretched / Math.hypot(...before) : 0) - across;
  const [x, y] = before.map((part) => part / Math.hypot(...before)) as [number, number];
  const numbers = [
    hasLength ? angle + TURN * Math.round((whole - angle) / TURN) : whole,
    across + excess * x * x,
    excess * x * y,
    across + excess * y * y,
  ];
  return { anchor: a, posed: c, bone: before, depth: handle.depth, numbers, passedOn: passedOn(numbers) };
}

function sourcesOf({ joints, bones }: Shares, handles: readonly Handle[]): (Source | null)[] {
  const place = ({ handle, segment, fraction }: Anchor) =>
    between(...segmentOf((handles[handle] as Handle).posed, segment), fraction);
  const places = joints.map((anchors) => mean(anchors.map(place)));
  return [
    ...handles.map((handle) => (handle.kind === 'point' ? pointSource(handle) : null)),
    ...bones.map((bone) => boneSource(bone, handles, places)),
  ];
}

/** Applies [a, b, c, d], which maps x to (a, b) and y to (c, d). */
const mapped = ([a = 0, b = 0, c = 0, d = 0]: readonly number[], [x, y]: Place): Place => [
  a * x + c * y,
  b * x + d * y,
];

export interface PosedSites {
  /** Sites × 6, as in a clip. */
  readonly motions: Float64Array;
  readonly depths: Float64Array;
}

/** @param rest Sites × 2. */
export function posedSites(shares: Shares, handles: readonly Handle[], rest: Float64Array): PosedSites {
  const sources = sourcesOf(shares, handles).map(
    (source) => source && { ...source, maps: [linearOf(source.numbers), linearOf(source.passedOn)] as const },
  );
  const motions = new Float64Array(shares.driven.length * NUMBERS);
  const depths = new Float64Array(shares.driven.length);
  let row = 0;
  shares.driven.forEach((kind, site) => {
    const place: Place = [rest[2 * site] ?? 0, rest[2 * site + 1] ?? 0];
    const add = (at: number, share: number, along: number, isOwn: boolean) => {
      const source = sources[at];
      if (!source) return;
      const { anchor, posed, bone, depth, numbers, passedOn, maps } = source;
      const [x, y] = mapped(maps[isOwn ? 0 : 1], minus(place, anchor));
      const [kept, less] = [mapped(maps[0], bone), mapped(maps[1], bone)];
      const all = [
        ...(isOwn ? numbers : passedOn),
        posed[0] + x + along * (kept[0] - less[0]) - place[0],
        posed[1] + y + along * (kept[1] - less[1]) - place[1],
      ];
      all.forEach((number, k) => {
        motions[site * NUMBERS + k] = (motions[site * NUMBERS + k] ?? 0) + share * number;
      });
      depths[site] = (depths[site] ?? 0) + share * depth;
    };
    if (kind > 1) add(kind - 2, 1, 0, true);
    if (kind === 0)
      for (const { source, share, along } of shares.rows[row++] ?? []) add(source, share, along, false);
  });
  return { motions, depths };
}
