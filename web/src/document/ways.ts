/**
 * The paths between two poses that the fold guard searches, as flat arrays for the solver.
 *
 * Each has the handles of the solution, then those that are not solved yet: all of them stop together.
 */
import type { Vec } from '../geometry/vec';
import { groupCentre } from './group';
import { rotationOf, SCALES, scaleOf, type Turns } from './handle';
import { handlePoses, readPoses, withPose } from './handle_poses';
import type { Handle, Project } from './project';
import { followedHandles, hasSameForm } from './solved';

/** A pose of the handles of a solution. */
export interface FollowedPoses {
  readonly handles: readonly Handle[];
  readonly poses: Float64Array;
  /** Returns the project with the poses of an array of this layout. */
  apply(poses: Float64Array): Project;
}

/** A path on which each handle moves independently. */
export interface HandleWay {
  readonly from: Float64Array;
  readonly to: Float64Array;
  /** Handles × 3: the turn at the start and at the end, in degrees, and 1 if the rotation is a number, else 0. */
  readonly turns: Float64Array;
  /** Returns the wanted project with the poses of an array of this layout. */
  apply(poses: Float64Array): Project;
}

/** A path on which handles turn and scale together. The others are at its end already. */
export interface GroupWay {
  readonly to: Float64Array;
  /** Indices of the handles that turn and scale. */
  readonly members: Uint32Array;
  /** Poses and rotations of the members before the transform. */
  readonly origins: Float64Array;
  readonly rotations: Float64Array;
  readonly pivot: Vec;
  /** Range of the scale that keeps the scales of all members in {@link SCALES}. */
  readonly scales: readonly [least: number, most: number];
  apply(poses: Float64Array): Project;
}

/** The poses of the solution's handles in a project. */
export function followedPoses(solved: Project, project: Project): FollowedPoses {
  const handles = followedHandles(solved, project);
  return {
    handles,
    poses: handlePoses(handles),
    apply: (poses) => applied(project, handles, handles, poses),
  };
}

/** @param turns The turns of automatic points in `from`. */
export function handleWay(solved: Project, from: Project, to: Project, turns: Turns): HandleWay {
  const ends = wayHandles(solved, to);
  const starts = ends.map(counterparts(from));
  const turning = (end: Handle, k: number) => {
    const start = starts[k] ?? end;
    return [rotationOf(start, turns), rotationOf(end, turns), end.rotation === 'auto' ? 0 : 1];
  };
  return {
    from: handlePoses(starts.map((start, k) => start ?? (ends[k] as Handle))),
    to: handlePoses(ends),
    turns: Float64Array.from(ends.flatMap(turning)),
    apply: (poses) => applied(to, ends, ends, poses),
  };
}

/** @param selection Ids of the handles that turn and scale together. */
export function groupWay(
  solved: Project,
  origin: Project,
  selection: readonly string[],
  to: Project,
): GroupWay {
  const ends = wayHandles(solved, to);
  const group = origin.handles.filter(({ id }) => selection.includes(id));
  const starts = ends.map(counterparts({ ...origin, handles: group }));
  const members = starts.flatMap((base, index) => (base ? [{ base, index }] : []));
  const scales = group.map(scaleOf);
  return {
    to: handlePoses(ends),
    members: Uint32Array.from(members, ({ index }) => index),
    origins: handlePoses(members.map(({ base }) => base)),
    rotations: Float64Array.from(members, ({ base }) => rotationOf(base)),
    pivot: groupCentre(group),
    scales: [Math.min(1, SCALES.least / Math.min(...scales)), Math.max(1, SCALES.most / Math.max(...scales))],
    apply: (poses) =>
      applied(
        to,
        ends,
        ends.map((end, k) => starts[k] ?? end),
        poses,
      ),
  };
}

/** Returns the handles of the solution in the project's pose, then the project's other handles. */
function wayHandles(solved: Project, project: Project): readonly Handle[] {
  const followed = followedHandles(solved, project);
  const ids = new Set(followed.map(({ id }) => id));
  return [...followed, ...project.handles.filter(({ id }) => !ids.has(id))];
}

/** Finds the handle of a project with the same name and form. */
function counterparts({ handles }: Project): (handle: Handle) => Handle | undefined {
  const byId = new Map(handles.map((handle) => [handle.id, handle]));
  return (handle) => {
    const found = byId.get(handle.id);
    return found && hasSameForm(found, handle) ? found : undefined;
  };
}

/** Returns the project with the poses of the handles `ends`, each written to the handle in `bases`. */
function applied(
  project: Project,
  ends: readonly Handle[],
  bases: readonly Handle[],
  poses: Float64Array,
): Project {
  const read = readPoses(poses);
  const posed = new Map(
    ends.map((end, k) => {
      const [base = end, pose] = [bases[k], read[k]];
      return [end, pose ? withPose(base, pose) : base];
    }),
  );
  return { ...project, handles: project.handles.map((handle) => posed.get(handle) ?? handle) };
}
