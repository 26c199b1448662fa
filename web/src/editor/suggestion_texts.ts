/** Texts about suggested handles. */

export const SUGGESTING = 'Looking for places for handles';

/** Handles are there. */
export const NO_SUGGESTION = 'No handle was added: there is one near every place that would get one.';

/** No handles are there. */
export const NO_PLACE = 'This picture has no room for a handle.';

export const countedSteps = (count: number): string => (count === 1 ? '1 handle' : `${count} handles`);

/**
 * @param added at least one.
 * @param there handles that were there before, which stay.
 * @param outlined the handles follow an outline.
 */
export function suggestedText(added: number, there: number, outlined: boolean): string {
  const rows = outlined || added === 1 ? '' : ' in even rows, since there is no outline to follow';
  if (there === 0) return `Placed ${countedSteps(added)}${rows}. Drag one to bend the picture.`;
  const stay = there === 1 ? 'The one that was there stays.' : `The ${there} that were there stay.`;
  return `Added ${countedSteps(added)}${rows}. ${stay}`;
}
