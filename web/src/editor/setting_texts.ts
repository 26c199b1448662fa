/** The settings in words: a name, and the effect of each on the picture. */
import type { SettingName } from '../document/settings';

/** The names as undo steps have them. */
export const SETTING_NAMES: Readonly<Record<SettingName, string>> = {
  samples: 'the samples',
  shape_factor: 'the support factor α',
  degree: 'the degree of the falloff',
  filling: 'the filling of the falloff',
  support: 'the rule of supports',
  continuity: 'the continuity',
  density: 'the number of virtual handles',
  blend: 'the blend',
  threshold: 'the least opacity',
  loose_parts: 'the motion of loose parts',
};
