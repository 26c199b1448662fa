/** Texts about a rig that is used on another picture. */

export const USE_RIG = 'Use this rig';

/**
 * A project waits for its picture.
 *
 * @param picture the name of an open picture that can take its handles, or null.
 */
export function awaitingText(
  project: string,
  { src, width, height }: { readonly src: string; readonly width: number; readonly height: number },
  picture: string | null,
): string {
  const whose = `${project} belongs to the picture ${src || 'it was made for'} (${width} × ${height} px).`;
  return `${whose} Open that picture to go on${picture === null ? '.' : `, or use its rig on ${picture}.`}`;
}

/** The name of the step, for Undo. */
export const rigStepText = (name: string): string => `Use rig of ${name}`;

const listed = new Intl.ListFormat('en-GB');

/** @param handles names of handles that were moved into the outline, at least one. */
export const movedInsideText = (handles: readonly string[]): string =>
  handles.length === 1
    ? `${handles[0]} was beside this picture and was moved onto it.`
    : `${listed.format(handles.length > 6 ? [...handles.slice(0, 5), `${handles.length - 5} more`] : handles)} were beside this picture and were moved onto it.`;
