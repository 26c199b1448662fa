/**
 * The keys of a clip: pure edits.
 *
 * Two keys of one handle at the same time are one. A key that is moved or pasted onto another one replaces it.
 */
import type { Vec } from '../geometry/vec';
import { checkedHandle, depthOf, scaleOf } from './handle';
import type { Clip, Ease, Handle, Key, Posed, Rotation, Track } from './project';

/** A key by its handle and its time. */
export interface KeyRef {
  readonly handle: string;
  readonly time: number;
}

/** A key with its handle. */
export interface PlacedKey {
  readonly handle: string;
  readonly key: Key;
}

/** The values of a key besides its places. */
export const KEYED_VALUES = ['rotation', 'scale', 'depth'] as const;
export type KeyedValue = (typeof KEYED_VALUES)[number];

/** Times closer than this are the same, in seconds. */
const SAME_TIME = 1e-6;

export const isSameTime = (a: number, b: number): boolean => Math.abs(a - b) < SAME_TIME;

/** Whether some of the references are to the key of a handle at a time. */
export const refersTo = (refs: readonly KeyRef[], handle: string, time: number): boolean =>
  refs.some((ref) => ref.handle === handle && isSameTime(ref.time, time));

export const isSameKey = (a: KeyRef, b: KeyRef): boolean => refersTo([a], b.handle, b.time);

export const trackOf = ({ tracks }: Clip, handle: string): Track | undefined =>
  tracks.find((track) => track.handle === handle);

export const keysAt = (clip: Clip, refs: readonly KeyRef[]): readonly PlacedKey[] =>
  clip.tracks.flatMap(({ handle, keys }) =>
    keys.filter(({ time }) => refersTo(refs, handle, time)).map((key) => ({ handle, key })),
  );

/** Puts keys in their order of time, in the place of those at the same times. */
export const putKeys = (clip: Clip, placed: readonly PlacedKey[]): Clip => ({
  ...clip,
  tracks: placed.reduce(putKey, clip.tracks),
});

function putKey(tracks: readonly Track[], { handle, key }: PlacedKey): readonly Track[] {
  const track = tracks.find((track) => track.handle === handle);
  if (!track) return [...tracks, { handle, keys: [key] }];
  const others = track.keys.filter(({ time }) => !isSameTime(time, key.time));
  const keys = [...others, key].sort((a, b) => a.time - b.time);
  return tracks.map((other) => (other === track ? { handle, keys } : other));
}

/** Removes keys, and tracks that are left without any. */
export const removeKeys = (clip: Clip, refs: readonly KeyRef[]): Clip => ({
  ...clip,
  tracks: clip.tracks.flatMap((track) => {
    const keys = track.keys.filter(({ time }) => !refersTo(refs, track.handle, time));
    return keys.length === 0 ? [] : keys.length === track.keys.length ? track : { ...track, keys };
  }),
});

export interface MovedKeys {
  readonly clip: Clip;
  readonly refs: readonly KeyRef[];
}

/** The seconds by which keys can move, of those wanted: all of them stay within the clip. */
export function allowedMove(clip: Clip, refs: readonly KeyRef[], by: number): number {
  const times = keysAt(clip, refs).map(({ key }) => key.time);
  if (times.length === 0) return 0;
  return Math.min(Math.max(by, -Math.min(...times)), clip.duration - Math.max(...times));
}

/** Moves keys in time by the same seconds, as far as all of them stay within the clip. */
export function moveKeys(clip: Clip, refs: readonly KeyRef[], by: number): MovedKeys {
  const moving = keysAt(clip, refs);
  const allowed = allowedMove(clip, refs, by);
  if (allowed === 0) return { clip, refs };
  const moved = moving.map(({ handle, key }) => ({
    handle,
    key: { ...key, time: roundedTime(key.time + allowed) },
  }));
  return {
    clip: putKeys(removeKeys(clip, refs), moved),
    refs: refs.map(({ handle, time }) => ({ handle, time: roundedTime(time + allowed) })),
  };
}

/** The keys that a clip has and another one lacks, or has with other values. */
export const newKeys = (clip: Clip, before: Clip): readonly KeyRef[] =>
  clip.tracks.flatMap(({ handle, keys }) =>
    keys
      .filter((key) => {
        const [old] = keysAt(before, [{ handle, time: key.time }]);
        return JSON.stringify(old?.key) !== JSON.stringify(key);
      })
      .map((key) => refOf({ handle, key })),
  );

/**
 * Returns the key beside another one, or null. A step of x goes to the next key in time. A step of y goes to the next
 * handle that has keys, and there to the nearest in time.
 *
 * @param handles all of them, from the top.
 */
export function keyBeside(clip: Clip, handles: readonly string[], from: KeyRef, [x, y]: Vec): KeyRef | null {
  const timesOf = (handle: string) => (trackOf(clip, handle)?.keys ?? []).map(({ time }) => time);
  const apart = (time: number) => Math.abs(time - from.time);
  const refTo = (handle: string, [time]: readonly number[]) => (time === undefined ? null : { handle, time });
  if (y === 0) {
    const others = timesOf(from.handle).filter((time) => (time - from.time) * x > SAME_TIME);
    return refTo(
      from.handle,
      others.sort((a, b) => apart(a) - apart(b)),
    );
  }
  const at = handles.indexOf(from.handle);
  const rows = y < 0 ? handles.slice(0, at).reverse() : handles.slice(at + 1);
  const row = rows.find((handle) => timesOf(handle).length > 0);
  return row === undefined
    ? null
    : refTo(
        row,
        timesOf(row).sort((a, b) => apart(a) - apart(b)),
      );
}

export const refOf = ({ handle, key: { time } }: PlacedKey): KeyRef => ({ handle, time });

/** Rounds to a hundred-thousandth of a second: thirds of a frame stay apart, and files stay short. */
export const roundedTime = (seconds: number): number => Math.round(seconds * 1e5) / 1e5 || 0;

/** Sets the ease of the stretches after keys. */
export const easeKeys = (clip: Clip, refs: readonly KeyRef[], ease: Ease): Clip =>
  putKeys(
    clip,
    keysAt(clip, refs).map(({ handle, key }) => ({ handle, key: { ...key, ease } })),
  );

/** The corners of a key, as a list. */
export const keyCorners = (posed: Posed): readonly Vec[] =>
  Array.isArray(posed[0]) ? (posed as readonly Vec[]) : [posed as Vec];

/**
 * The handle with the values of a key.
 * @throws RangeError with the reason if the handle cannot have them.
 */
export const withKey = (handle: Handle, { time, ease, ...values }: Key): Handle =>
  checkedHandle({ ...handle, ...values } as Handle);

/**
 * Whether a new key at a time holds a value, like other keys of its track. A depth applies until another key changes
 * it, so a new key holds one only if it replaces a key with a depth.
 */
export const isKeyed = (track: Track | undefined, time: number, value: KeyedValue): boolean =>
  track?.keys.some(
    (key) => key[value] !== undefined && (value !== 'depth' || isSameTime(key.time, roundedTime(time))),
  ) ?? false;

/** A key that holds the posed corners of a handle, and these of its other values. */
export const keyOf = (handle: Handle, time: number, values: readonly KeyedValue[]): Key => ({
  time: roundedTime(time),
  posed: handle.posed,
  ...(values.includes('rotation') ? { rotation: givenRotation(handle) } : {}),
  ...(values.includes('scale') ? { scale: scaleOf(handle) } : {}),
  ...(values.includes('depth') ? { depth: depthOf(handle) } : {}),
  ease: 'smooth',
});

const givenRotation = ({ rotation }: Handle): Rotation => rotation ?? 0;
