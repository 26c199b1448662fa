/**
 * Thins a recorded motion to few keys that stay near it.
 *
 * Keys are added where the motion between them is farthest off. Then those are dropped that are not needed.
 */
import { distance } from '../geometry/vec';
import { keyOf, roundedTime } from './clip_keys';
import { corners, isAutomatic, isLine, rotationOf, scaleOf } from './handle';
import { withPose } from './handle_poses';
import type { PosesAt } from './moment';
import type { Clip, Handle, Key } from './project';

/** The allowed error: image pixels, degrees, and parts of the size. */
const ALLOWED = { pixels: 1, degrees: 1, scale: 0.01 } as const;

/** A handle with its pose at a time. */
export interface PosedSample {
  readonly time: number;
  readonly handle: Handle;
}

/** @param samples in ascending order of time. */
export function thinned(samples: readonly PosedSample[], posesAt: PosesAt): readonly Key[] {
  const values = valuesOf(samples);
  const keys = samples.map(({ time, handle }) => keyOf(handle, time, values));
  if (keys.length < 3) return keys;
  const motion: Motion = { samples, keys, posesAt };
  return dropped(motion, refined(motion)).map((k) => keys[k] as Key);
}

interface Motion {
  readonly samples: readonly PosedSample[];
  /** A key for each sample. */
  readonly keys: readonly Key[];
  readonly posesAt: PosesAt;
}

/** Chooses keys until all samples are near them. Returns their indices. */
function refined(motion: Motion): readonly number[] {
  const last = motion.keys.length - 1;
  let chosen: readonly number[] = [0, last];
  const errors = errorsBetween(motion, chosen, 0, 1);
  for (;;) {
    const worst = errors.indexOf(Math.max(...errors));
    if ((errors[worst] ?? 0) <= 1 || chosen.includes(worst)) return chosen;
    chosen = [...chosen, worst].sort((a, b) => a - b);
    // The speeds at both neighbours change too, and with them the ways beyond.
    const at = chosen.indexOf(worst);
    const from = Math.max(0, at - 2);
    const changed = errorsBetween(motion, chosen, from, Math.min(chosen.length - 1, at + 2));
    changed.forEach((error, k) => {
      errors[(chosen[from] ?? 0) + k] = error;
    });
  }
}

/** Drops the keys that are not needed. */
function dropped(motion: Motion, indices: readonly number[]): readonly number[] {
  let chosen = indices;
  for (let at = 1; at < chosen.length - 1; ) {
    const without = chosen.toSpliced(at, 1);
    const [from, to] = [Math.max(0, at - 2), Math.min(without.length - 1, at + 1)];
    if (Math.max(...errorsBetween(motion, without, from, to)) <= 1) chosen = without;
    else at++;
  }
  return chosen;
}

/** How far the samples between two of the chosen keys are off. A way depends only on its adjacent keys. */
function errorsBetween(
  { samples, keys, posesAt }: Motion,
  chosen: readonly number[],
  from: number,
  to: number,
): number[] {
  const around = chosen.slice(Math.max(0, from - 1), to + 2).map((k) => keys[k] as Key);
  const within = samples.slice(chosen[from], (chosen[to] ?? 0) + 1);
  const [first] = within;
  if (!first) return [];
  const clip = clipOf(first.handle, around);
  return within.map((sample) => errorOf(sample, clip, posesAt));
}

/** The values that the motion changes, besides the places. */
function valuesOf(samples: readonly PosedSample[]): readonly ('rotation' | 'scale')[] {
  const [first] = samples;
  if (!first) return [];
  const turns = !isLine(first.handle) && !isAutomatic(first.handle);
  const grows = samples.some(({ handle }) => scaleOf(handle) !== scaleOf(first.handle));
  return [...(turns ? (['rotation'] as const) : []), ...(grows ? (['scale'] as const) : [])];
}

const clipOf = ({ id }: Handle, keys: readonly Key[]): Clip => ({
  name: 'recorded',
  // Times of keys count from the beginning of the clip that is recorded into.
  duration: Math.max(keys.at(-1)?.time ?? 0, 1e-3),
  loop: 'none',
  tracks: [{ handle: id, keys }],
});

/** How far the keys are off at a sample, as a part of the allowed error. */
function errorOf({ time, handle }: PosedSample, clip: Clip, posesAt: PosesAt): number {
  const [pose] = posesAt(clip, [handle], roundedTime(time));
  if (!pose) return 0;
  const posed = withPose(handle, pose);
  const moved = corners(posed).map((corner, k) => distance(corner, corners(handle)[k] ?? corner));
  return Math.max(
    ...moved.map((pixels) => pixels / ALLOWED.pixels),
    Math.abs(rotationOf(posed) - rotationOf(handle)) / ALLOWED.degrees,
    Math.abs(scaleOf(posed) / scaleOf(handle) - 1) / ALLOWED.scale,
  );
}
