/** Settings that a page has for new projects. */
import type { ProjectFile } from './project';

const KEYS = ['samples', 'weighting', 'pose', 'fix_boundary', 'edges', 'loose_parts'] as const;

/** Keys as in a project file. Those that are left out are the editor's. */
export type ProjectDefaults = Partial<Pick<ProjectFile, (typeof KEYS)[number]>>;

/** @throws RangeError that names an unknown key; TypeError for anything but an object. The solver checks the values. */
export function checkDefaults(given: unknown): asserts given is ProjectDefaults {
  if (typeof given !== 'object' || given === null || Array.isArray(given))
    throw new TypeError('defaults: expected an object of settings');
  for (const key of Object.keys(given)) {
    if (!(KEYS as readonly string[]).includes(key))
      throw new RangeError(`defaults: unknown key "${key}"; expected one of ${KEYS.join(', ')}`);
  }
}
