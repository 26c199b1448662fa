/**
 * The two modes of bending, each a choice of several settings.
 *
 * Rigid needs many virtual sites, and supports wide enough to be smooth. Harmonic is the method of the paper.
 * The solver defines both.
 */
import type { Blend } from '../geometry/skin';
import { EDITOR_SETTINGS, PAPER_SETTINGS } from './generated/settings';
import type { Handle, PoseMode, Project, Rotation } from './project';

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

/**
 * Returns the project in another mode. Unturned points take that mode's resting rotation. The others keep their turn.
 *
 * @param last the last project in that mode. Its detail and the rotations of its unturned points are restored.
 */
export function withMode(project: Project, mode: PoseMode, last: Project | null = null): Project {
  const { support, density, rotation } = SETTINGS[mode];
  const before = new Map(last?.handles.filter(isUnturned).map((handle) => [handle.id, handle.rotation]));
  const resting = ({ id }: Handle) => before.get(id) ?? rotation;
  return {
    ...project,
    weighting: { ...project.weighting, support },
    pose: { ...project.pose, mode, density: last?.pose?.density ?? density },
    handles: project.handles.map((handle) =>
      isUnturned(handle) ? { ...handle, rotation: resting(handle) } : handle,
    ),
  };
}

/** The detail of a project, or `null` if its density is not in {@link DETAILS}. */
export const detailOf = (project: Project): Detail | null =>
  (Object.keys(DETAILS) as Detail[]).find((name) => DETAILS[name] === project.pose?.density) ?? null;

export const withDetail = (project: Project, detail: Detail): Project => ({
  ...project,
  pose: { ...project.pose, density: DETAILS[detail] },
});

const isUnturned = ({ kind, rotation = 0 }: Handle): boolean =>
  kind === 'point' && (rotation === 0 || rotation === 'auto');
