/** The study card, which explains the method on the open picture: its pages, and what they show. */

export const STUDY_PAGES = ['settings'] as const;
export type StudyPage = (typeof STUDY_PAGES)[number];

export interface StudyState {
  /** The page on show; null while the card is closed. */
  readonly page: StudyPage | null;
}

export const NO_STUDY: StudyState = { page: null };
