/** Notices: sentences over the picture, with the words of their buttons. */
import { counted, fewNames, number, plural, quoted } from './language';

const GRAPHICS_LOST = 'The browser lost access to the graphics card and cannot show the picture.';

const inRows = (rows: boolean): string =>
  rows ? ' in even rows, because the picture has no outline to follow' : '';

/** @param source the name of the picture, which may be empty. */
const belonging = (project: string, source: string, width: number, height: number): string =>
  `${project} belongs to ${source === '' ? 'another picture' : `the picture ${source}`} (${width} × ${height} px).`;

export const notices = {
  nothingToHold: 'Place the handle on the picture.',
  lassoOutside: 'The picture does not bend outside the selection.',
  lassoEmpty: 'The lasso is empty. Draw it around a part of the picture.',
  drawingEnded: 'The drawing has ended.',
  lassoFilled: 'Only this part bends now, over a filled background.',
  lassoLoose: 'Only this part bends now. It leaves a gap where it moves away.',
  partOnFrame: 'The part touches the locked edge of the picture, so it cannot turn.',
  leftOut: (count: number) =>
    plural(count, {
      one: 'One handle outside the lasso was removed. Undo restores it.',
      other: `${count} handles outside the lasso were removed. Undo restores them.`,
    }),
  notKept:
    'This browser cannot store your work: its storage is full or blocked. Save the project before you leave.',
  newerWork:
    'This browser holds work from a newer version of the editor, which is kept. Reload the page to update, or save the project before you leave.',
  otherTab: 'Another tab also changed this work. Both versions are kept. Reload the page to choose one.',
  twoVersions: (picture: string) => `${picture} was changed in two tabs. This is the later version.`,
  graphicsLost: `${GRAPHICS_LOST} Reload the page.`,
  graphicsLostStored: `${GRAPHICS_LOST} Your work is safe. Reload the page.`,
  graphicsLostUnstored: `${GRAPHICS_LOST} Save the project, then reload the page.`,
  clipNameTaken: (name: string) =>
    `Another clip is already called ${quoted(name)}. The name was not changed.`,

  /** Handles that lie partly outside of the part that bends. */
  outsidePicture: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `Part of ${handles[0]} lies outside the picture and has no effect.`,
      other: `Parts of ${fewNames(handles)} lie outside the picture and have no effect.`,
    }),
  outsideLasso: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `Part of ${handles[0]} lies outside the lasso and has no effect.`,
      other: `Parts of ${fewNames(handles)} lie outside the lasso and have no effect.`,
    }),
  /** A typed name is refused. @param name that stays. */
  nameStays: {
    empty: (name: string) => `A handle needs a name. The name ${quoted(name)} was kept.`,
    taken: (name: string) => `Another handle has this name. The name ${quoted(name)} was kept.`,
  },
  outlineSimplified: 'This outline is very fine, so the warp follows it less closely.',
  /** @param pixels the widest gap that is bridged. */
  outlineBridged: (pixels: number) =>
    `This outline is too fine to follow: parts up to ${pixels} pixels apart bend together.`,
  outlinePicture: 'This outline is too fine to follow: the whole picture bends.',
  looseParts: (count: number) =>
    plural(count, {
      one: 'One part has no handle and stays in place.',
      other: `${count} parts have no handle and stay in place.`,
    }),
  sameThere: 'Both sides already match.',
  noOtherSide: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `The mirrored position of ${handles[0]} is outside the picture.`,
      other: `The mirrored positions of ${fewNames(handles)} are outside the picture.`,
    }),
  noCounterpart: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `No handle here matches the pose of ${handles[0]}.`,
      other: `No handles here match the poses of ${fewNames(handles)}.`,
    }),
  brushedStill: 'All handles were reset. Brush strokes remain.',

  noPose: 'The clipboard has no pose. Copy one first.',
  /** @param detail the fault, in English. */
  badPose: (detail: string) => `Could not paste this pose: ${detail}.`,
  badKeys: (detail: string) => `Could not paste these keys: ${detail}.`,
  notCopied: 'The browser blocked the clipboard. You can paste the copy on this page only.',
  /** @param keys that copy. */
  notCopiedByMenu: (keys: string) =>
    `The browser blocked the clipboard. You can paste the copy on this page only. To copy for other pages, press ${keys}.`,
  notRead: 'The browser blocked the clipboard. Allow access to paste.',
  /** @param keys that paste. */
  notReadByMenu: (keys: string) => `The browser blocked the clipboard. Press ${keys} to paste.`,

  emptyAddress: 'Enter an address that starts with https://.',
  noAddress: (text: string) =>
    `${quoted(text)} is not the address of a picture. Enter one that starts with https:// or data:image/.`,
  nothingDropped: 'Drop a picture or a link to one.',
  /** @param why a sentence. */
  notCarried: (picture: string, why: string) => `${picture} opened without its project. ${why}`,
  removed: (picture: string) => `${picture} was removed from the list.`,
  removedAll: (count: number) => `${count} pictures were removed from the list.`,
  /** @param more the number of further files. */
  notOpened: (file: string, more: number) =>
    `Only one picture opens at a time. ${more === 0 ? `${file} was` : `${file} and ${more} more were`} not opened.`,
  moves: (picture: string) => `${picture} is animated. Only its first frame was opened.`,
  lacksTexts: (picture: string) =>
    `${picture} takes long to draw, so it was opened without its texts. Convert them to paths to see them.`,
  isOpen: (picture: string) => `${picture} is open.`,
  saved: (file: string) => `Saved as ${file}.`,
  savedCut: (file: string) => `Saved as ${file}. Parts beyond the frame were cut off.`,
  selectOne: 'Select one handle first.',

  /** A project waits for its picture. @param source the name of that picture, which may be empty. */
  awaiting: (project: string, source: string, width: number, height: number) =>
    `${belonging(project, source, width, height)} Open that picture to continue.`,
  /** @param picture the open one. */
  awaitingOrRig: (project: string, source: string, width: number, height: number, picture: string) =>
    `${belonging(project, source, width, height)} Open that picture to continue, or use this rig on ${picture}.`,
  /** The name of a project that came with a picture of another size. */
  theProject: 'The project',
  movedInside: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `${handles[0]} was outside this picture and was moved onto it.`,
      other: `${fewNames(handles)} were outside this picture and were moved onto it.`,
    }),

  folds: 'The picture folds over itself.',
  /** @param handles that force the folds. */
  foldedBy: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} folds the picture.`,
      other: `${fewNames(handles, quoted)} together fold the picture.`,
    }),
  leftFolds: (handles: readonly string[]) =>
    `${fewNames(handles, quoted)} moved back to the nearest pose without folds.`,
  noWayOut: 'Found no pose without folds between this pose and the rest pose.',

  placed: (added: number, rows: boolean) =>
    `Placed ${counted(added, 'handle')}${inRows(rows)}. Drag one to bend the picture.`,
  added: (added: number, there: number, rows: boolean) =>
    `Added ${counted(added, 'handle')}${inRows(rows)}. ${plural(there, {
      one: 'The existing handle stays.',
      other: `The ${number(there)} existing handles stay.`,
    })}`,
  noSuggestion: 'No handles were added: every suitable place already has one nearby.',
  noPlace: 'This picture has no room for a handle.',

  noKeysSelected: 'Select keys first.',
  noCopiedKeys: 'Copy keys first.',
  copiedKeys: (count: number) => `Copied ${counted(count, 'key')}`,
  keysLeftOut: (count: number) =>
    plural(count, {
      one: '1 key was left out. It is beyond the end of the clip, or its handle is missing.',
      other: `${count} keys were left out. They are beyond the end of the clip, or their handles are missing.`,
    }),

  /** The editor as an installed program. */
  newVersion: 'A new version is ready. It starts the next time you open the editor.',
  newVersionWaits: 'A new version is ready. It starts after you close all other editor windows.',
  notOffline:
    'The editor does not work offline yet: the download was interrupted. It resumes at the next start.',
  offered: (files: readonly string[]) => `A link or another program wants to open ${fewNames(files)}.`,
  shareFailed: 'Could not receive the shared picture. Open its file here.',
  notGiven: (file: string) => `Could not read ${file}: it was moved or changed. Open it here.`,
};

/** The words of buttons in notices. */
export const answers = {
  tryAgain: 'Try again',
  continueDrawing: 'Continue drawing',
  takeBack: 'Clear strokes',
  exportAll: 'Export the whole picture',
  holdBoundary: 'Lock its outline',
  extendSelection: 'Extend the selection',
  letFollow: 'Let them follow',
  putBack: 'Restore',
  showOtherVersion: 'Show the other version',
  keepThis: 'Keep this one',
  backTo: (picture: string) => `Back to ${picture}`,
  open: 'Open',
  openPicture: 'Open picture',
  useRig: 'Use this rig',
};
