/** Notices: sentences over the picture, with the words of their buttons. */
import { counted, fewNames, number, plural, quoted } from './language';

const GRAPHICS_LOST = 'The graphics card is gone, so the picture cannot be shown.';

const inRows = (rows: boolean): string => (rows ? ' in even rows, since there is no outline to follow' : '');

export const notices = {
  nothingToHold: 'There is nothing to hold here: place the handle on the picture.',
  lassoOutside: 'Outside of the selection, the picture stays still.',
  lassoEmpty: 'The lasso is empty: draw it around a part of the picture.',
  lassoFilled: 'Only this part bends now, over a filled background.',
  lassoLoose: 'Only this part bends now. It leaves a gap where it moves away.',
  partOnFrame: 'The part lies along the frame of the picture, which is held: it cannot turn.',
  leftOut: (count: number) =>
    plural(count, {
      one: 'One handle outside the lasso was removed. Undo brings it back.',
      other: `${count} handles outside the lasso were removed. Undo brings them back.`,
    }),
  notKept:
    'Your work is not stored in this browser: its storage is full or blocked. Save the project before you leave.',
  otherTab: 'Another tab has changed this work too. Both versions are kept: a reload offers them.',
  twoVersions: (picture: string) => `${picture} was changed in two tabs. This is the later version.`,
  graphicsLost: `${GRAPHICS_LOST} Reload the page.`,
  graphicsLostStored: `${GRAPHICS_LOST} Nothing is lost: reload the page.`,
  graphicsLostUnstored: `${GRAPHICS_LOST} Nothing is lost yet: save the project, then reload the page.`,
  clipNameTaken: (name: string) => `Another clip has the name "${name}". The old name stays.`,

  /** Handles that lie partly outside of the part that bends. */
  outsidePicture: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `Part of ${handles[0]} lies outside the picture and moves nothing.`,
      other: `Parts of ${fewNames(handles)} lie outside the picture and move nothing.`,
    }),
  outsideLasso: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `Part of ${handles[0]} lies outside the lasso and moves nothing.`,
      other: `Parts of ${fewNames(handles)} lie outside the lasso and move nothing.`,
    }),
  /** A typed name is refused. @param name that stays. */
  nameStays: {
    empty: (name: string) => `A handle needs a name: ${quoted(name)} keeps its own.`,
    taken: (name: string) => `Another handle has this name: ${quoted(name)} keeps its own.`,
  },
  outlineSimplified: 'This outline is very fine, so it is followed less closely.',
  /** @param pixels the widest gap that is bridged. */
  outlineBridged: (pixels: number) =>
    `This outline is too fine to be followed: parts up to ${pixels} pixels apart bend together.`,
  outlinePicture: 'This outline is too fine to be followed: the whole picture bends.',
  looseParts: (count: number) =>
    plural(count, {
      one: 'One part has no handle and stays behind.',
      other: `${count} parts have no handle and stay behind.`,
    }),
  sameThere: 'Both sides are the same already.',
  noOtherSide: (handles: readonly string[]) =>
    `The picture has nothing on the other side of ${fewNames(handles)}.`,
  noCounterpart: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `No handle here matches the pose of ${handles[0]}.`,
      other: `No handles here match the poses of ${fewNames(handles)}.`,
    }),
  brushedStill: 'The handles are at rest. Strokes of the brush stay.',

  noPose: 'There is no pose on the clipboard: copy one first.',
  /** @param detail the fault, in English. */
  badPose: (detail: string) => `This pose cannot be pasted: ${detail}.`,
  notCopied: 'The browser blocked the clipboard: the pose can be pasted on this page only.',
  /** @param keys that copy. */
  notCopiedByMenu: (keys: string) =>
    `The browser blocked the clipboard: the pose can be pasted on this page only. ${keys} copies it for other pages.`,
  notRead: 'The browser blocked the clipboard: allow it to paste.',
  /** @param keys that paste. */
  notReadByMenu: (keys: string) => `The browser blocked the clipboard: press ${keys} to paste.`,

  emptyAddress: 'There is no address: type one that begins with https://',
  noAddress: (text: string) =>
    `${quoted(text)} is no address of a picture: it must begin with https:// or data:image/.`,
  nothingDropped: 'There is no picture in this drop, and no address of one.',
  /** @param why a sentence. */
  notCarried: (picture: string, why: string) => `${picture} opened as a picture only. ${why}`,
  removed: (picture: string) => `${picture} was removed from the list.`,
  removedAll: (count: number) => `${count} pictures were removed from the list.`,
  /** @param more the number of further files. */
  notOpened: (file: string, more: number) =>
    `Only one picture opens at a time: ${more === 0 ? `${file} was` : `${file} and ${more} more were`} not opened.`,
  moves: (picture: string) => `${picture} moves. Only its first frame is open.`,
  lacksTexts: (picture: string) =>
    `${picture} takes long to draw, so it is open without its texts. Convert them to paths to see them.`,
  isOpen: (picture: string) => `${picture} is open.`,
  saved: (file: string) => `Saved as ${file}.`,
  savedCut: (file: string) => `Saved as ${file}. The part beyond the frame is cut off.`,
  selectOne: 'This is about one handle: select it first.',

  /** A project waits for its picture. @param source the name of that picture, which may be empty. */
  awaiting: (project: string, source: string, width: number, height: number) =>
    `${project} belongs to the picture ${source || 'it was made for'} (${width} × ${height} px). Open that picture to go on.`,
  /** @param picture the open one. */
  awaitingOrRig: (project: string, source: string, width: number, height: number, picture: string) =>
    `${project} belongs to the picture ${source || 'it was made for'} (${width} × ${height} px). Open that picture to go on, or use its rig on ${picture}.`,
  /** The name of a project that came with a picture of another size. */
  theProject: 'The project',
  movedInside: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `${handles[0]} was beside this picture and was moved onto it.`,
      other: `${fewNames(handles)} were beside this picture and were moved onto it.`,
    }),

  folds: 'The picture folds.',
  /** @param handles that force the folds. */
  foldedBy: (handles: readonly string[]) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} folds the picture.`,
      other: `${fewNames(handles, quoted)} fold the picture between them.`,
    }),
  leftFolds: (handles: readonly string[]) =>
    `${fewNames(handles, quoted)} moved back to the nearest pose without folds.`,
  noWayOut: 'No pose without folds was found between this one and the rest pose.',

  placed: (added: number, rows: boolean) =>
    `Placed ${counted(added, 'handle')}${inRows(rows)}. Drag one to bend the picture.`,
  added: (added: number, there: number, rows: boolean) =>
    `Added ${counted(added, 'handle')}${inRows(rows)}. ${plural(there, {
      one: 'The one that was there stays.',
      other: `The ${number(there)} that were there stay.`,
    })}`,
  noSuggestion: 'No handle was added: there is one near every place that would get one.',
  noPlace: 'This picture has no room for a handle.',

  noKeysSelected: 'No keys are selected.',
  noCopiedKeys: 'No keys have been copied.',
  copiedKeys: (count: number) => `Copied ${counted(count, 'key')}`,
  keysLeftOut: (count: number) =>
    plural(count, {
      one: '1 key was left out: beyond the end of the clip, or of a handle that is not here.',
      other: `${count} keys were left out: beyond the end of the clip, or of a handle that is not here.`,
    }),

  /** The editor as an installed program. */
  newVersion: 'A new version is ready. It opens at the next start.',
  newVersionWaits: 'A new version is ready. It opens once the other windows of the editor are closed.',
  notOffline:
    'The editor is not stored for use without a network: the download broke off. The next start tries again.',
  shareFailed: 'The shared picture did not arrive. Open its file here.',
  notGiven: (file: string) => `${file} cannot be read: it was moved or changed. Open it here.`,
};

/** The words of buttons in notices. */
export const answers = {
  tryAgain: 'Try again',
  takeBack: 'Take it back',
  exportAll: 'Export all',
  holdBoundary: 'Hold its boundary',
  extendSelection: 'Extend the selection',
  letFollow: 'Let them follow',
  putBack: 'Put back',
  showOtherVersion: 'Show the other version',
  keepThis: 'Keep this one',
  backTo: (picture: string) => `Back to ${picture}`,
  openPicture: 'Open picture',
  useRig: 'Use this rig',
};
