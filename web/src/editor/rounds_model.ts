/** One round of Algorithm 1 as the replay shows it. */

import type { Round, SiteStudy, Study } from '../document/generated/study';
import type { Project } from '../document/project';
import { say, type Wording } from '../texts/wording';
import { siteName } from './lens_words';
import type { StudyState } from './study_state';

export interface RoundModel {
  readonly study: Study;
  readonly index: number;
  readonly round: Round;
  /** Sites before the round. */
  readonly sites: readonly SiteStudy[];
  readonly words: Wording;
}

/** The rounds of the explained solution; empty until they are known. */
export const roundsOf = ({ explained }: StudyState): readonly Round[] => explained?.study?.rounds ?? [];

/** The round on show, at first the last one; null until it is known. */
export function roundModel(state: StudyState): RoundModel | null {
  const { study, of } = state.explained ?? {};
  if (!study || !of || study.rounds.length === 0) return null;
  const last = study.rounds.length - 1;
  const index = Math.min(state.replay.round ?? last, last);
  const round = study.rounds[index] as Round;
  const words = roundWords(study, index, round, of.project);
  return { study, index, round, sites: study.sites.slice(0, round.sites), words };
}

/** A description of the round's effect. */
function roundWords({ sites, allowed_score }: Study, index: number, round: Round, project: Project): Wording {
  const [point, ...more] = round.points;
  const owner = point && sites[point.owner];
  const number = index + 1;
  if (!point || !owner) return say('rounds.end', number, round.sites);
  const isVirtual = owner.handle === -1;
  const name = isVirtual ? say('names.virtualHandle', point.owner + 1) : siteName(project, owner.handle);
  const enters = say('rounds.enters', name, px(point.distance), more.length);
  return round.score > allowed_score
    ? say('rounds.tooLarge', number, px(point.distance), px(point.limit), enters)
    : say('rounds.asked', number, enters);
}

const px = (length: number): string => `${Math.round(length)} px`;
