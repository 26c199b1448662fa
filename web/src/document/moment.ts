/**
 * A document at a time of a clip: its handles are posed by the clip, and changes of their poses become keys.
 *
 * The file holds the project without that: `fileProject`.
 */
import { isSameTime, KEYED_VALUES, type KeyedValue, keyOf, putKeys, trackOf } from './clip_keys';
import { changeClip, clipNamed } from './clips';
import { type Document, fileProject, handleById, isSameMoment } from './document';
import { corners, depthOf, posedAs, scaleOf } from './handle';
import { type HandlePose, handlePoses, withPose } from './handle_poses';
import type { Clip, Handle, Project } from './project';
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

/** Turns the changes since `before` into keys, if both are at the same moment. */
export function absorbed(before: Document, after: Document): Document {
  const { moment, project } = after;
  if (!moment || !isSameMoment(moment, before.moment) || project === before.project) return after;
  const changed: (readonly [handle: Handle, own: Handle])[] = [];
  const handles = project.handles.map((handle) => {
    const was = counterpart(before.project, handle);
    const base = counterpart(moment.base, handle);
    if (!was || !base || corners(base).length !== corners(handle).length) return handle;
    const own = posedAs(handle, base);
    if (!hasSamePose(was, handle)) changed.push([handle, own]);
    return own;
  });
  const keyed = changeClip(project, moment.clip, (clip) =>
    changed.reduce((next, [handle, own]) => withKey(next, handle, own, moment.time), clip),
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
    (value) => differs(handle, own, value) || track?.keys.some((key) => key[value] !== undefined),
  );
  const before = track?.keys.findLast((key) => key.time < time || isSameTime(key.time, time));
  const placed = [
    ...(start.time < time ? [{ ...keyOf(own, start.time, keyed), ...start }] : []),
    { ...keyOf(handle, time, keyed), ease: before?.ease ?? 'smooth' },
  ];
  return putKeys(
    clip,
    placed.map((key) => ({ handle: handle.id, key })),
  );
}

const differs = (a: Handle, b: Handle, value: KeyedValue): boolean =>
  keyOf(a, 0, KEYED_VALUES)[value] !== keyOf(b, 0, KEYED_VALUES)[value];
