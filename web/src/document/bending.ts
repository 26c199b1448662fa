/**
 * The two modes of bending, each a choice of several settings.
 *
 * Rigid needs many virtual sites, and supports wide enough to be smooth. Harmonic is the method of the paper.
 * The solver defines both.
 */
import type { Blend } from '../geometry/skin';
import { EDITOR_SETTINGS, PAPER_SETTINGS } from './generated/settings';
import { isLine, rotationOf, type Turns, turnedTo, withAutoRotation } from './handle';
import type { Handle, PoseMode, Project, Rotation } from './project';
import { placeKey } from './solved';

/** Virtual sites to request. More of them bend a rigid picture more finely. */
export const DETAILS = { coarse: 30, medium: EDITOR_SETTINGS.density, fine: 200 } as const;

export type Detail = keyof typeof DETAILS;

const SETTINGS = {
  [EDITOR_SETTINGS.mode]: EDITOR_SETTINGS,
  [PAPER_SETTINGS.mode]: PAPER_SETTINGS,
} as const satisfies Record<PoseMode, object>;

export const modeOf = (project: Project): PoseMode => project.pose?.mode ?? PAPER_SETTINGS.mode;

export const blendOf = (project: Project): Blend => project.pose?.blend ?? 'linear';

export const withBlend = (project: Project, blend: Blend): Project => ({
  ...project,
  pose: { ...project.pose, blend },
});

/** The rotation of an unturned point. */
export const restingRotation = (project: Project): Rotation => SETTINGS[modeOf(project)].rotation;

/** A handle without a rotation gets that of a new one: lines turn with their corners, points as in this mode. */
export const withNewRotation = (project: Project, handle: Handle): Handle =>
  handle.rotation === undefined && (isLine(handle) || restingRotation(project) === 'auto')
    ? withAutoRotation(handle)
    : handle;

/** A way back to a mode: the last project in it, and the first one after it. */
export interface ModeReturn {
  readonly before: Project;
  readonly after: Project;
}

/**
 * Returns the project in another mode. No shown turn changes on the way to harmonic: automatic points take the turn
 * that they have. On the way to rigid, unturned points become automatic.
 *
 * @param turns the turns of automatic points.
 * @param back restores the detail of the last project in that mode, and the rotations that the way from it changed.
 */
export function withMode(
  project: Project,
  mode: PoseMode,
  turns?: Turns,
  back: ModeReturn | null = null,
): Project {
  const { support, density } = SETTINGS[mode];
  const rotated =
    mode === 'rigid' ? freed(back) : (handle: Handle) => turnedTo(handle, rotationOf(handle, turns));
  return {
    ...project,
    weighting: { ...project.weighting, support },
    pose: { ...project.pose, mode, density: back?.before.pose?.density ?? density },
    handles: project.handles.map((handle) => (isLine(handle) ? handle : rotated(handle))),
  };
}

/** Makes points automatic as they were, if nobody has turned them since. */
function freed(back: ModeReturn | null): (handle: Handle) => Handle {
  const rotations = ({ handles }: Project) =>
    new Map(handles.map((handle) => [placeKey(handle), handle.rotation ?? 0]));
  const [before, after] = [back?.before, back?.after].map((project) => project && rotations(project));
  return (handle) => {
    const { rotation = 0 } = handle;
    const key = placeKey(handle);
    const last = after?.get(key) === rotation ? before?.get(key) : undefined;
    return last === 'auto' || (last === undefined && rotation === 0) ? withAutoRotation(handle) : handle;
  };
}

/** The detail of a project, or `null` if its density is not in {@link DETAILS}. */
export const detailOf = (project: Project): Detail | null =>
  (Object.keys(DETAILS) as Detail[]).find((name) => DETAILS[name] === project.pose?.density) ?? null;

export const withDetail = (project: Project, detail: Detail): Project => ({
  ...project,
  pose: { ...project.pose, density: DETAILS[detail] },
});
