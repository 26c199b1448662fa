/** The content of the lens, derived from the last answer. */
import type { Lens } from '../document/generated/lens';
import type { SiteStudy, Study } from '../document/generated/study';
import type { Project } from '../document/project';
import type { LensState, StudyState } from './study_state';

export interface LensModel {
  readonly lens: Lens;
  readonly study: Study;
  /** The project that was solved: names of handles. */
  readonly project: Project;
  /** The site whose falloff is shown, with its distance from the point; null without any. */
  readonly falloff: Falloff | null;
}

export interface Falloff {
  readonly index: number;
  readonly site: SiteStudy;
  readonly distance: number;
  /** φ at even steps from 0 to 1. */
  readonly curve: readonly number[];
}

/** Null until something is known about a point that bends. */
export function lensModel({ lens: state }: StudyState): LensModel | null {
  const { found } = state;
  if (!found?.lens) return null;
  const { lens, of, study } = found;
  return { lens, study, project: of.project, falloff: falloffOf(state, lens, study) };
}

function falloffOf({ site: chosen }: LensState, lens: Lens, study: Study): Falloff | null {
  const index = chosen ?? lens.sites[0]?.site;
  const distance = index === undefined ? undefined : distanceOf(lens, index);
  const site = index === undefined ? undefined : study.sites[index];
  if (index === undefined || distance === undefined || !site) return null;
  return { index, site, distance, curve: study.falloff };
}

const distanceOf = ({ shares, sites }: Lens, index: number): number | undefined =>
  (sites.find(({ site }) => site === index) ?? shares.find(({ site }) => site === index))?.distance;
