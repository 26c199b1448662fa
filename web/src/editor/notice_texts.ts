/** Texts of notices that name what was ignored, or where nothing can be placed. */

export const NOTHING_TO_HOLD = 'There is nothing to hold here: place the handle on the picture.';

export const LASSO_OUTSIDE = 'This part of the picture stays: place the handle inside what the lasso holds.';
export const LASSO_EMPTY = 'The lasso holds nothing: draw it around a part of the picture.';
export const LASSO_LOOSE = 'Only this part bends now. Where it moves away, it leaves a gap.';

/** @param count of handles that lie outside of a lasso; at least one. */
export const leftOutText = (count: number): string =>
  count === 1
    ? 'One handle lay outside of the lasso, and is gone. Undo brings it back.'
    : `${count} handles lay outside of the lasso, and are gone. Undo brings them back.`;

export const NOT_KEPT =
  'Your work is not kept in this browser: it grants no storage, or has no more of it. Save the project before you leave.';

export const OVERWRITTEN =
  'Something was changed in another tab since: a reload brings back the work of that one. Any change here makes it this one again.';

const listed = new Intl.ListFormat('en-GB');

/** Names in a sentence, of many the first few: all handles of another picture would cover this one. */
const named = (handles: readonly string[]): string =>
  listed.format(handles.length > 6 ? [...handles.slice(0, 5), `${handles.length - 5} more`] : handles);

/**
 * @param handles names of handles that lie partly outside of what bends; at least one.
 * @param lassoed whether that is what a lasso holds, not the picture.
 */
export function outsideText(handles: readonly string[], lassoed = false): string {
  const where = lassoed ? 'inside the lasso' : 'on the picture';
  return handles.length === 1
    ? `Only the part of ${handles[0]} ${where} bends it: the rest lies beside it.`
    : `Only the parts ${where} bend it of ${named(handles)}.`;
}

export const SAME_THERE = 'The other side is the same: there is nothing to mirror.';

/** @param handles names of handles that have no place on the other side; at least one. */
export const noOtherSideText = (handles: readonly string[]): string =>
  `There is nothing to hold on the other side of ${named(handles)}.`;

/** @param handles names of copied handles that none is like; at least one. */
export const noCounterpartText = (handles: readonly string[]): string =>
  handles.length === 1
    ? `There is no handle here for the pose of ${handles[0]}.`
    : `There are no handles here for the poses of ${named(handles)}.`;

export const NO_POSE = 'There is no pose on the clipboard: copy one first.';

/** @param keys those that copy; null where there are none. */
export const notCopiedText = (keys: string | null): string =>
  `The browser let nothing onto the clipboard: the pose can be pasted on this page alone.${keys ? ` ${keys} copies it for others.` : ''}`;

/** @param keys those that paste; null where there are none. */
export const notReadText = (keys: string | null): string =>
  `The browser did not let the clipboard be read: ${keys ? `press ${keys}` : 'allow it'} to paste.`;

/** @param files names of files that were not opened; at least one. */
export function notOpenedText([first, ...more]: readonly string[]): string {
  const others = more.length === 0 ? `${first} was` : `${first} and ${more.length} more were`;
  return `One picture is open at a time: ${others} not opened.`;
}
