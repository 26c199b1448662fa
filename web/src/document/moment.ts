/**
 * A document at a time of a clip: its handles are posed by the clip, and changes of their poses become keys.
 *
 * The file holds the project without that: `fileProject`.
 */
import {
  isKeyed,
  isSameTime,
  KEYED_VALUES,
  type KeyedValue,
  keyOf,
  putKeys,
  roundedTime,
  trackOf,
} from './clip_keys';
import { changeClip, clipNamed } from './clips';
import { type Document, fileProject, handleById, isSameMoment } from './document';
import { corners, depthOf, posedAs, scaleOf } from './handle';
import { type HandlePose, handlePoses, withPose } from './handle_poses';
import type { Clip, Handle, Key, Project } from './project';
import { placeKey } from './solved';

/** The poses of handles at a time of a clip, in the order of the handles. */
export type PosesAt = (clip: Clip, handles: readonly Handle[], time: number) => readonly HandlePose[];

/**
 * The document at a time of a clip; unposed if it has no such clip.
 *
 * @param held ids of handles that keep the pose that they have.
 */
export function atMoment(
  document: Document,
  name: string,
  time: number,
  posesAt: PosesAt,
  held: readonly string[] = [],
): Document {
  const base = fileProject(document);
  const clip = clipNamed(base, name);
  if (!clip) return unposed(document);
  const poses = posesAt(clip, base.handles, time);
  const posed = (handle: Handle, k: number): Handle => {
    const pose = poses[k];
    const shown = held.includes(handle.id) ? handleById(document, handle.id) : undefined;
    return shown ?? (pose ? withPose(handle, pose) : handle);
  };
  return {
    ...document,
    project: { ...base, handles: base.handles.map(posed) },
    moment: { clip: name, time, base },
  };
}

/** Whether the clip of the document's moment poses all handles: none is held or returning. */
export function isAlong(document: Document, posesAt: PosesAt): boolean {
  const { moment, project } = document;
  if (!moment) return false;
  const { handles } = atMoment(document, moment.clip, moment.time, posesAt).project;
  const [posed, present] = [handlePoses(handles), handlePoses(project.handles)];
  return posed.length === present.length && posed.every((value, k) => Object.is(value, present[k]));
}

/** The document without the poses of a clip. */
export const unposed = ({ moment, ...document }: Document): Document =>
  moment ? { ...document, project: moment.base } : document;

/** The document with another project in its file, until that is posed at a moment. */
export const withFileProject = ({ selection }: Document, project: Project): Document => ({
  project,
  selection,
});

/** Whether a handle is behind nothing that it crosses, at another time of the document's clip. */
export type IsFree = (handle: string, time: number) => boolean;

/** Turns the changes since `before` into keys, if both are at the same moment. */
export function absorbed(before: Document, after: Document, isFree: IsFree = () => false): Document {
  const { moment, project } = after;
  if (!moment || !isSameMoment(moment, before.moment) || project === before.project) return after;
  const changed: (readonly [handle: Handle, own: Handle, by: number])[] = [];
  const handles = project.handles.map((handle) => {
    const was = counterpart(before.project, handle);
    const base = counterpart(moment.base, handle);
    if (!was || !base || corners(base).length !== corners(handle).length) return handle;
    const own = posedAs(handle, base);
    if (!hasSamePose(was, handle)) changed.push([handle, own, depthOf(handle) - depthOf(was)]);
    return own;
  });
  const keyed = changeClip(project, moment.clip, (clip) =>
    changed.reduce((next, [handle, own, by]) => {
      const posed = withKey(next, handle, own, moment.time);
      if (by === 0) return posed;
      return withDepth(posed, handle, own, moment.time, (id, time) => by > 0 && isFree(id, time));
    }, clip),
  );
  return { ...after, project: keyed, moment: { ...moment, base: { ...keyed, handles } } };
}

/** The same handle before a change, also if it had another name. */
const counterpart = ({ handles }: Project, handle: Handle): Handle | undefined =>
  handles.find(({ id }) => id === handle.id) ?? handles.find((other) => placeKey(other) === placeKey(handle));

const hasSamePose = (a: Handle, b: Handle): boolean =>
  JSON.stringify([a.posed, a.rotation, scaleOf(a), depthOf(a)]) ===
  JSON.stringify([b.posed, b.rotation, scaleOf(b), depthOf(b)]);

/** Sets a key of a handle. Values that had no key before start from the handle's own pose. */
function withKey(clip: Clip, handle: Handle, own: Handle, time: number): Clip {
  const track = trackOf(clip, handle.id);
  const start = track?.keys[0] ?? { time: 0, ease: 'smooth' as const };
  const keyed = KEYED_VALUES.filter(
    (value) => isKeyed(track, time, value) || (value !== 'depth' && differs(handle, own, value)),
  );
  const begun = keyed.filter((value) => value !== 'depth');
  const before = track?.keys.findLast((key) => key.time < time || isSameTime(key.time, time));
  const placed = [
    ...(start.time < time ? [{ ...keyOf(own, start.time, begun), ...start }] : []),
    { ...keyOf(handle, time, keyed), ease: before?.ease ?? 'smooth' },
  ];
  return putKeys(
    clip,
    placed.map((key) => ({ handle: handle.id, key })),
  );
}

/**
 * Gives the key of a handle at a time a depth, which goes on until another key changes it. On the way to that key, the
 * handle may begin to cross another part. So the key before gets the depth too, if the handle is free there.
 */
export function withDepth(clip: Clip, handle: Handle, own: Handle, time: number, isFree: IsFree): Clip {
  const keys = trackOf(clip, handle.id)?.keys ?? [];
  const at = roundedTime(time);
  const before = keys.findLast((key) => key.time < at && !isSameTime(key.time, at));
  const isFirst = keys.every((key) => key.depth === undefined);
  const depthAt = (key: Key): number | undefined => {
    if (isSameTime(key.time, at)) return depthOf(handle);
    if (key === before && key.depth === undefined && isFree(handle.id, key.time)) return depthOf(handle);
    return isFirst && key === keys[0] ? depthOf(own) : undefined;
  };
  const placed = keys.flatMap((key) => {
    const depth = depthAt(key);
    return depth === undefined ? [] : { handle: handle.id, key: { ...key, depth } };
  });
  return putKeys(clip, placed);
}

const differs = (a: Handle, b: Handle, value: KeyedValue): boolean =>
  keyOf(a, 0, KEYED_VALUES)[value] !== keyOf(b, 0, KEYED_VALUES)[value];
