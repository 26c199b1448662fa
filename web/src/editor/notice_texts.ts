/** Texts of notices. */
import type { NameFault } from '../document/names';
import type { OutlineDetail } from './solution';

export const NOTHING_TO_HOLD = 'There is nothing to hold here: place the handle on the picture.';

export const LASSO_OUTSIDE = 'Outside of the selection, the picture stays still.';
export const CORNER_CROSSES = 'The outline would cross itself there';
export const CORNER_STAYS = 'The outline needs this corner';
export const PART_ON_FRAME = 'The part lies along the frame of the picture, which is held: it cannot turn.';
export const LASSO_EMPTY = 'The lasso is empty: draw it around a part of the picture.';
export const LASSO_FILLED = 'Only this part bends now, over a filled background.';
export const LASSO_LOOSE = 'Only this part bends now. It leaves a gap where it moves away.';

/** @param count the number of handles outside a lasso, at least one. */
export const leftOutText = (count: number): string =>
  count === 1
    ? 'One handle outside the lasso was removed. Undo brings it back.'
    : `${count} handles outside the lasso were removed. Undo brings them back.`;

export const NOT_KEPT =
  'Your work is not stored in this browser: its storage is full or blocked. Save the project before you leave.';

export const OTHER_TAB =
  'Another tab has changed this work too. Both versions are kept: a reload offers them.';

export const twoVersionsText = (picture: string): string =>
  `${picture} was changed in two tabs. This is the later version.`;

export const NEW_VERSION = 'A new version is ready. It opens at the next start.';
export const NEW_VERSION_WAITS =
  'A new version is ready. It opens once the other windows of the editor are closed.';
export const NOT_OFFLINE =
  'The editor is not stored for use without a network: the download broke off. The next start tries again.';
export const SHARE_FAILED = 'The shared picture did not arrive. Open its file here.';

/** @param name of a file that the system gave. */
export const notGivenText = (name: string): string =>
  `${name} cannot be read: it was moved or changed. Open it here.`;

const GRAPHICS_LOST = 'The graphics card is gone, so the picture cannot be shown.';

/** @param stored whether a reload brings the work back; null without work that could be lost. */
export function graphicsLostText(stored: boolean | null): string {
  if (stored === null) return `${GRAPHICS_LOST} Reload the page.`;
  return stored
    ? `${GRAPHICS_LOST} Nothing is lost: reload the page.`
    : `${GRAPHICS_LOST} Nothing is lost yet: save the project, then reload the page.`;
}

export const clipNameTakenText = (name: string): string =>
  `Another clip has the name "${name}". The old name stays.`;

const listed = new Intl.ListFormat('en-GB');

/** Names in a sentence. Of many names only the first few, since a long notice would cover the picture. */
const named = (handles: readonly string[]): string =>
  listed.format(handles.length > 6 ? [...handles.slice(0, 5), `${handles.length - 5} more`] : handles);

/** The same with quotation marks around each name. */
export const namedInQuotes = (handles: readonly string[]): string =>
  listed.format(
    handles.length > 6
      ? [...handles.slice(0, 5).map(quoted), `${handles.length - 5} more`]
      : handles.map(quoted),
  );

const quoted = (name: string): string => `“${name}”`;

/**
 * @param handles names of handles that lie partly outside the part that bends, at least one.
 * @param lassoed a lasso bounds the part that bends.
 */
export function outsideText(handles: readonly string[], lassoed = false): string {
  const where = lassoed ? 'the lasso' : 'the picture';
  return handles.length === 1
    ? `Part of ${handles[0]} lies outside ${where} and moves nothing.`
    : `Parts of ${named(handles)} lie outside ${where} and move nothing.`;
}

/** Why a handle cannot have a name. */
export const NAME_FAULTS: Readonly<Record<NameFault, string>> = {
  empty: 'A handle needs a name.',
  taken: 'Another handle has this name.',
};

/** @param name that of a handle whose new name was refused. */
export const nameStaysText = (fault: NameFault, name: string): string =>
  `${NAME_FAULTS[fault].slice(0, -1)}: “${name}” keeps its own.`;

/**
 * Null for an outline that follows the picture.
 *
 * @param gap the widest gap that is bridged, in image pixels.
 */
export function outlineText(outline: OutlineDetail, gap: number): string | null {
  switch (outline) {
    case 'traced':
      return null;
    case 'simplified':
      return 'This outline is very fine, so it is followed less closely.';
    case 'bridged':
      return `This outline is too fine to be followed: parts up to ${Math.ceil(gap)} pixels apart bend together.`;
    case 'picture':
      return 'This outline is too fine to be followed: the whole picture bends.';
  }
}

/** @param count the number of parts without a handle, at least one. */
export const looseText = (count: number): string =>
  count === 1 ? 'One part has no handle and stays behind.' : `${count} parts have no handle and stay behind.`;

export const SAME_THERE = 'Both sides are the same already.';

/** @param handles names of handles without a place on the other side, at least one. */
export const noOtherSideText = (handles: readonly string[]): string =>
  `The picture has nothing on the other side of ${named(handles)}.`;

/** @param handles names of copied handles without a counterpart, at least one. */
export const noCounterpartText = (handles: readonly string[]): string =>
  handles.length === 1
    ? `No handle here matches the pose of ${handles[0]}.`
    : `No handles here match the poses of ${named(handles)}.`;

export const NO_POSE = 'There is no pose on the clipboard: copy one first.';

/** @param keys the keys that copy; null on a device without keys. */
export const notCopiedText = (keys: string | null): string =>
  `The browser blocked the clipboard: the pose can be pasted on this page only.${keys ? ` ${keys} copies it for other pages.` : ''}`;

/** @param keys the keys that paste; null on a device without keys. */
export const notReadText = (keys: string | null): string =>
  `The browser blocked the clipboard: ${keys ? `press ${keys}` : 'allow it'} to paste.`;

/** @param text given by a person as an address. */
export const noAddressText = (text: string): string =>
  text.trim() === ''
    ? 'There is no address: type one that begins with https://'
    : `“${text.trim().slice(0, 60)}” is no address of a picture: it must begin with https:// or data:image/.`;

export const NOTHING_DROPPED = 'There is no picture in this drop, and no address of one.';

/** @param why a project in a picture cannot be read, as a sentence. */
export const notCarriedText = (picture: string, why: string): string =>
  `${picture} opened as a picture only. ${why}`;

/** @param works recent works, at least one. */
export const removedText = ([first, ...more]: readonly { readonly name: string }[]): string =>
  more.length === 0
    ? `${first?.name} was removed from the list.`
    : `${more.length + 1} pictures were removed from the list.`;

/** @param files names of files that were not opened, at least one. */
export function notOpenedText([first, ...more]: readonly string[]): string {
  const others = more.length === 0 ? `${first} was` : `${first} and ${more.length} more were`;
  return `Only one picture opens at a time: ${others} not opened.`;
}

/** @param picture the name of a file with several frames. */
export const movesText = (picture: string): string => `${picture} moves. Only its first frame is open.`;

/** @param cut a part beyond the picture's own rectangle is missing in the file. */
export const savedText = (name: string, cut: boolean): string =>
  cut ? `Saved as ${name}. The part beyond the frame is cut off.` : `Saved as ${name}.`;

export const EXPORT_CANCELLED = 'The export was cancelled';

export const SELECT_ONE = 'This is about one handle: select it first.';

/** All handles were reset, but the brush has moved places too. */
export const BRUSHED_STILL = 'The handles are at rest. Strokes of the brush stay.';
