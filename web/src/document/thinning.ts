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

/** A handle as it was posed at a time. */
export interface PosedSample {
  readonly time: number;
  readonly handle: Handle;
}

/** @param samples in ascending order of time. */
export function thinned(samples: readonly PosedSample[], posesAt: PosesAt): readonly Key[] {
  const values = valuesOf(samples);
  const keys = samples.map(({ time, handle }) => keyOf(handle, time, values));
  const [first] = samples;
  if (!first || keys.length < 3) return keys;
  const errors = (chosen: readonly number[]) => {
    const clip = clipOf(
      first.handle,
      chosen.map((k) => keys[k] as Key),
    );
    return samples.map((sample) => errorOf(sample, clip, posesAt));
  };
  let chosen: readonly number[] = [0, keys.length - 1];
  for (;;) {
    const found = errors(chosen);
    const worst = found.indexOf(Math.max(...found));
    if ((found[worst] ?? 0) <= 1 || chosen.includes(worst)) break;
    chosen = [...chosen, worst].sort((a, b) => a - b);
  }
  for (const k of chosen.slice(1, -1)) {
    const without = chosen.filter((other) => other !== k);
    if (Math.max(...errors(without)) <= 1) chosen = without;
  }
  return chosen.map((k) => keys[k] as Key);
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
