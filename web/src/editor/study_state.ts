/** The study card explains the method on the open picture: its pages and their content. */

import type { Lens } from '../document/generated/lens';
import type { Study } from '../document/generated/study';
import type { Variant } from '../document/variants';
import type { Vec } from '../geometry/vec';
import type { Wording } from '../texts/wording';
import type { Solution } from './solution';

export const STUDY_PAGES = ['lens', 'cells', 'rounds', 'compare', 'settings'] as const;
export type StudyPage = (typeof STUDY_PAGES)[number];

/** The figures that can be saved. */
export type FigureName = Exclude<StudyPage, 'settings'>;

export interface StudyState {
  /** The page on show; null while the card is closed. */
  readonly page: StudyPage | null;
  /** An explained solution: the shown one, or the one before while that is asked about. */
  readonly explained: Explained | null;
  /** The solution that is asked about. */
  readonly asked: Solution | null;
  readonly lens: LensState;
  readonly replay: ReplayState;
  /** Why the solver refused a method of the comparison; null where it did not. */
  readonly refusals: Readonly<Record<Variant, Wording | null>>;
}

export interface ReplayState {
  /** The round on show, from 0; null for the last. */
  readonly round: number | null;
  readonly playing: boolean;
}

export interface LensState {
  /** The point under the lens at rest, image pixels; null until one is pointed at. */
  readonly at: Vec | null;
  /** Whether the lens stays while the pointer moves on. */
  readonly pinned: boolean;
  /** Whether the next answer is announced: the lens was moved on purpose. */
  readonly speaks: boolean;
  /** The question under way. One at a time: the next one is asked once this one is answered. */
  readonly asked: LensPlace | null;
  /** The last answer, with its explained solution; `lens` is null where nothing bends. */
  readonly found: FoundLens | null;
  /** The site whose falloff is shown; null for the heaviest. */
  readonly site: number | null;
}

/** A solution, explained; null if the solver could not. */
export interface Explained {
  readonly of: Solution;
  readonly study: Study | null;
}

export interface FoundLens extends LensPlace {
  readonly lens: Lens | null;
  readonly study: Study;
}

/** A point of a solution's picture at rest. */
export interface LensPlace {
  readonly of: Solution;
  readonly at: Vec;
}

export const NO_STUDY: StudyState = {
  page: null,
  explained: null,
  asked: null,
  lens: { at: null, pinned: false, speaks: false, asked: null, found: null, site: null },
  replay: { round: null, playing: false },
  refusals: { paper: null, rigid: null, plain: null },
};
