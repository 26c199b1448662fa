/** One round of Algorithm 1 as the replay shows it. */
import type { Round, SiteStudy, Study } from '../document/generated/study';
import type { Project } from '../document/project';
import { siteName } from './lens_texts';
import type { StudyState } from './study_state';

export interface RoundModel {
  readonly study: Study;
  readonly index: number;
  readonly round: Round;
  /** Sites before the round. */
  readonly sites: readonly SiteStudy[];
  readonly words: string;
}

/** The rounds of the explained solution; none until they are known. */
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

/** The effect of the round, in words. */
function roundWords({ sites, allowed_score }: Study, index: number, round: Round, project: Project): string {
  const [point, ...more] = round.points;
  const owner = point && sites[point.owner];
  const title = `Round ${index + 1}: `;
  if (!point || !owner) return `${title}the end. No cell is too large, and there are ${round.sites} handles.`;
  const name = owner.handle === -1 ? `virtual handle ${point.owner + 1}` : siteName(project, owner.handle);
  const others = more.length > 0 ? `, and ${more.length} more elsewhere` : '';
  const enters = `A virtual handle enters in the cell of ${name}, ${px(point.distance)} away${others}.`;
  if (round.score > allowed_score) {
    return `${title}a cell reaches ${px(point.distance)} far, and ${px(point.limit)} are allowed. ${enters}`;
  }
  return `${title}no cell is too large, but the project asks for more virtual handles. ${enters}`;
}

const px = (length: number): string => `${Math.round(length)} px`;
