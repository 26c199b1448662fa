/**
 * The two modes of bending, each a choice of several settings.
 *
 * Rigid needs many virtual sites, and supports wide enough to be smooth. Harmonic is the method of the paper.
 * The solver defines both.
 */
import type { Blend } from '../geometry/skin';
import { EDITOR_SETTINGS, PAPER_SETTINGS } from './generated/settings';
import { isLine, posedAs, withAutoRotation } from './handle';
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
 * Returns the project in another mode. Turns keep their meaning: numbers stay, and automatic points stay automatic. On
 * the way to rigid, unturned points become automatic, as those placed in that mode are.
 *
 * @param back undoes the changes of the way from that mode. Later changes stay.
 */
export function withMode(project: Project, mode: PoseMode, back: ModeReturn | null = null): Project {
  if (back && JSON.stringify(back.after) === JSON.stringify(project)) return back.before;
  const { support, density } = SETTINGS[mode];
  const { pose, weighting } = back?.before ?? {};
  return {
    ...project,
    weighting: { ...project.weighting, support: weighting?.support ?? support },
    pose: { ...project.pose, mode, density: pose?.density ?? density },
    handles: project.handles.map((handle) => (isLine(handle) ? handle : rotatedAs(handle, mode, back))),
  };
}

/** A point with the rotation that it had in the mode, or with the one that its rotation means there. */
function rotatedAs(handle: Handle, mode: PoseMode, back: ModeReturn | null): Handle {
  const [before, after] = [back?.before, back?.after].map((project) =>
    project?.handles.find((other) => placeKey(other) === placeKey(handle)),
  );
  const stayed =
    after?.rotation === handle.rotation &&
    // An automatic point that was moved has turned since.
    (mode === 'rigid' || JSON.stringify(after?.posed) === JSON.stringify(handle.posed));
  if (before && after && stayed) return posedAs(handle, { ...handle, rotation: before.rotation } as Handle);
  return mode === 'rigid' && (handle.rotation ?? 0) === 0 ? withAutoRotation(handle) : handle;
}

/** The detail of a project, or `null` if its density is not in {@link DETAILS}. */
export const detailOf = (project: Project): Detail | null =>
  (Object.keys(DETAILS) as Detail[]).find((name) => DETAILS[name] === project.pose?.density) ?? null;

export const withDetail = (project: Project, detail: Detail): Project => ({
  ...project,
  pose: { ...project.pose, density: DETAILS[detail] },
});
