/**
 * How the picture bends: the settings that belong together, as one choice.
 *
 * Rigid needs many virtual sites to bend between, and supports wide enough to be smooth. Harmonic is the method of the
 * paper. `Project::bent_rigidly` in wasm/core/src/project has the same settings.
 */
import type { Blend } from '../geometry/skin';
import type { Handle, PoseMode, Project, Rotation } from './project';

/** Virtual sites to request: how finely a rigid picture can bend. */
export const DETAILS = { coarse: 30, medium: 100, fine: 200 } as const;

export type Detail = keyof typeof DETAILS;

const SETTINGS = {
  rigid: { support: 'smooth', density: DETAILS.medium, rotation: 'auto' },
  harmonic: { support: 'paper', density: 0, rotation: 0 },
} as const satisfies Record<PoseMode, object>;

export const modeOf = (project: Project): PoseMode => project.pose?.mode ?? 'harmonic';

export const blendOf = (project: Project): Blend => project.pose?.blend ?? 'linear';

export const withBlend = (project: Project, blend: Blend): Project => ({
  ...project,
  pose: { ...project.pose, blend },
});

/** The rotation of an unturned point. */
export const restingRotation = (project: Project): Rotation => SETTINGS[modeOf(project)].rotation;

/**
 * The project in another mode. Unturned points take that mode's resting rotation; the others keep their turn.
 *
 * @param last what was last in that mode: its detail comes back, and points that were unturned in it are as they were.
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

/** The detail of a project; null where its density is none of {@link DETAILS}. */
export const detailOf = (project: Project): Detail | null =>
  (Object.keys(DETAILS) as Detail[]).find((name) => DETAILS[name] === project.pose?.density) ?? null;

export const withDetail = (project: Project, detail: Detail): Project => ({
  ...project,
  pose: { ...project.pose, density: DETAILS[detail] },
});

const isUnturned = ({ kind, rotation = 0 }: Handle): boolean =>
  kind === 'point' && (rotation === 0 || rotation === 'auto');
