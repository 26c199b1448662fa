/** Texts about folds, and the handles that force them. */
import { namedInQuotes } from './notice_texts';

export const WITHOUT_FOLDS = 'Nearest pose without folds';

export const NO_WAY_OUT = 'No pose without folds was found between this one and the rest pose.';

/** @param handles names of the handles that force the folds. */
export function foldsText(handles: readonly string[]): string {
  if (handles.length === 0) return 'The picture folds.';
  const names = namedInQuotes(handles);
  return handles.length === 1 ? `${names} folds the picture.` : `${names} fold the picture between them.`;
}

/** @param moved names of the handles that were moved, at least one. */
export const leftFoldsText = (moved: readonly string[]): string =>
  `${namedInQuotes(moved)} moved back to the nearest pose without folds.`;
