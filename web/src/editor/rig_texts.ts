/** Texts about a rig that is used on another picture. */

import { nameOf } from '../document/handle';

/** More names are a number. */
const MOST_NAMED = 6;

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

/** @param moved ids of handles that were moved into the outline, at least one. */
export function movedInsideText(moved: readonly string[]): string {
  const names = moved.map((id) => nameOf({ id }));
  const [only, ...more] = names;
  if (more.length === 0) return `${only} was beside this picture and was moved onto it.`;
  const named = names.length > MOST_NAMED ? [...names.slice(0, 5), `${names.length - 5} more`] : names;
  return `${listed.format(named)} were beside this picture and were moved onto it.`;
}
