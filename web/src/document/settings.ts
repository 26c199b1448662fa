/** The settings of a project that are numbers or choices, one by one. */

import { withMode } from './bending';
import { domainOf } from './domain';
import type { Blend, Continuity, Filling, LooseParts, Support } from './generated/project';
import { EDITOR_SETTINGS, PAPER_SETTINGS } from './generated/settings';
import type { PoseMode, Project } from './project';

export interface Settings {
  readonly samples: number;
  /** α. */
  readonly shape_factor: number;
  readonly degree: number;
  readonly filling: Filling;
  readonly support: Support;
  readonly continuity: Continuity;
  readonly density: number;
  readonly blend: Blend;
  /** Minimum opacity of the domain; null where the domain does not depend on it. */
  readonly threshold: number | null;
  readonly loose_parts: LooseParts;
}

export type SettingName = keyof Settings;

/** A setting with a new value. */
export type Setting = {
  readonly [N in SettingName]: { readonly name: N; readonly value: NonNullable<Settings[N]> };
}[SettingName];

/** The threshold that a project file leaves out. */
const THRESHOLD = 0.5;
/** The continuity that a project file leaves out. */
const CONTINUITY: Continuity = 'exact';

/** All settings of a project. What its file leaves out is as in the paper. */
export function settingsOf({ samples, weighting, pose, domain, loose_parts }: Project): Settings {
  return {
    samples: samples ?? PAPER_SETTINGS.samples,
    shape_factor: weighting?.shape_factor ?? PAPER_SETTINGS.shape_factor,
    degree: weighting?.degree ?? PAPER_SETTINGS.degree,
    filling: weighting?.filling ?? PAPER_SETTINGS.filling,
    support: weighting?.support ?? PAPER_SETTINGS.support,
    continuity: weighting?.continuity ?? CONTINUITY,
    density: pose?.density ?? PAPER_SETTINGS.density,
    blend: pose?.blend ?? PAPER_SETTINGS.blend,
    threshold: domain?.kind === 'alpha' ? (domain.threshold ?? THRESHOLD) : null,
    loose_parts: loose_parts ?? 'stay',
  };
}

export function withSetting(project: Project, { name, value }: Setting): Project {
  switch (name) {
    case 'samples':
      return { ...project, samples: value };
    case 'loose_parts':
      return { ...project, loose_parts: value };
    case 'density':
    case 'blend':
      return { ...project, pose: { ...project.pose, [name]: value } };
    case 'threshold':
      return { ...project, domain: domainOf(value) };
    case 'continuity': {
      const { continuity: _, ...weighting } = project.weighting ?? {};
      return {
        ...project,
        weighting: value === CONTINUITY ? weighting : { ...weighting, continuity: value },
      };
    }
    default:
      return { ...project, weighting: { ...project.weighting, [name]: value } };
  }
}

/** All settings of the paper, or those of the editor for new projects. */
export type Preset = 'paper' | 'editor';

const PRESETS = { paper: PAPER_SETTINGS, editor: EDITOR_SETTINGS } as const;

export const presetMode = (preset: Preset): PoseMode => PRESETS[preset].mode;

/**
 * Sets all settings but the threshold and loose parts, since they belong to the picture. Unturned points rest as the
 * mode has it.
 */
export function withPreset(project: Project, preset: Preset): Project {
  const { samples, shape_factor, degree, filling, support, mode, blend, density } = PRESETS[preset];
  return {
    ...withMode(project, mode),
    samples,
    weighting: { shape_factor, degree, filling, support },
    pose: { mode, blend, density },
  };
}
