/** Words of notices that depend on more than names and numbers. */
import { say, type Wording, type Words } from '../texts/wording';
import type { OutlineDetail } from './solution';

/** @param stored whether a reload brings the work back; null without work that could be lost. */
export function graphicsLostWords(stored: boolean | null): Wording {
  if (stored === null) return say('notices.graphicsLost');
  return say(stored ? 'notices.graphicsLostStored' : 'notices.graphicsLostUnstored');
}

/** @param handles names of the handles that force the folds. */
export const foldsWords = (handles: readonly Words[]): Wording =>
  handles.length === 0 ? say('notices.folds') : say('notices.foldedBy', handles);

/**
 * Null for an outline that follows the picture.
 *
 * @param gap the widest gap that is bridged, in image pixels.
 */
export function outlineWords(outline: OutlineDetail, gap: number): Wording | null {
  switch (outline) {
    case 'traced':
      return null;
    case 'simplified':
      return say('notices.outlineSimplified');
    case 'bridged':
      return say('notices.outlineBridged', Math.ceil(gap));
    case 'picture':
      return say('notices.outlinePicture');
  }
}

/** @param text given by a person as an address. */
export const noAddressWords = (text: string): Wording =>
  text.trim() === '' ? say('notices.emptyAddress') : say('notices.noAddress', text.trim().slice(0, 60));

/** @param works recent works, at least one. */
export const removedWords = ([first, ...more]: readonly { readonly name: string }[]): Wording =>
  more.length === 0 ? say('notices.removed', first?.name ?? '') : say('notices.removedAll', more.length + 1);

/** @param files names of files that were not opened, at least one. */
export const notOpenedWords = ([first = '', ...more]: readonly string[]): Wording =>
  say('notices.notOpened', first, more.length);

/** @param cut a part beyond the picture's own rectangle is missing in the file. */
export const savedWords = (name: string, cut: boolean): Wording =>
  say(cut ? 'notices.savedCut' : 'notices.saved', name);

/**
 * A project waits for its picture.
 *
 * @param picture the name of an open picture that can take its handles, or null.
 */
export function awaitingWords(
  project: Words,
  { src, width, height }: { readonly src: string; readonly width: number; readonly height: number },
  picture: string | null,
): Wording {
  return picture === null
    ? say('notices.awaiting', project, src, width, height)
    : say('notices.awaitingOrRig', project, src, width, height, picture);
}

/**
 * @param added at least one.
 * @param there handles that were there before, which stay.
 * @param outlined the handles follow an outline.
 */
export function suggestedWords(added: number, there: number, outlined: boolean): Wording {
  const rows = !outlined && added > 1;
  return there === 0 ? say('notices.placed', added, rows) : say('notices.added', added, there, rows);
}
