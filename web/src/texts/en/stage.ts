/** The stage: its labels, hints, drawings, the brush, and the line below it. */
import { counted } from './language';

export const stage = {
  keys: 'Arrow keys move the selection. Comma and full stop turn it or, with Alt, scale it.',
  noPicture: 'No picture',
  picture: (name: string) => `Picture ${name}`,
  /** @param picture the label of the picture. */
  disabled: (picture: string) => `${picture}, disabled`,
  posable: (picture: string) => `${picture}, with handles to pose it`,
  original: 'Original',
  opening: 'Opening…',
  drop: 'Drop a picture here, paste one, or',
  openPicture: 'Open a picture',
  /** A form is submitted without a picture. */
  required: 'Open a picture.',
  wouldFold: 'would fold here',
  dismiss: 'Dismiss',
  handles: 'Handles',
  selectionCorners: 'Corners of the selection',
  /** @param part the number of the part of several; null for a selection of one part. */
  selectionCorner: (corner: number, part: number | null, x: number, y: number) =>
    `Corner ${corner} of ${part === null ? 'the selection' : `part ${part} of the selection`}, x ${x}, y ${y}`,
  selectionCornerKeys: 'Arrow keys move the corner. Delete removes it, and C adds another after it.',
  /** The menu of a place of the picture. */
  pictureMenu: 'Picture',
  /** @param handle its name. */
  cornerMenu: (corner: number, handle: string) => `Corner ${corner} of ${handle}`,
};

export const hints = {
  bar: { click: 'Drag to draw a bar, or click its corners', tap: 'Drag to draw a bar, or tap its corners' },
  polygon: { click: 'Click the corners of the polygon', tap: 'Tap the corners of the polygon' },
  lasso: {
    click: 'Draw around the part to bend: drag, or click corners',
    tap: 'Draw around the part to bend: drag, or tap corners',
  },
  lassoAgain: 'Drag a corner of the selection, or draw around another part',
  select: {
    click: 'Choose the point tool, then click the picture',
    tap: 'Choose the point tool, then tap the picture',
  },
  point: {
    click: 'Click the picture where you want a handle',
    tap: 'Tap the picture where you want a handle',
  },
  snapToEdges: 'Snap to edges',
  snapToEdgesTip: 'The lasso follows edges in the picture. Hold Alt to draw freely',
};

export const drawing = {
  label: 'Drawing',
  ready: 'Add corners, or finish',
  oneMore: 'One more corner',
  more: (count: number) => `${count} more corners`,
  takeBack: 'Remove the last corner',
  giveUp: 'Cancel drawing',
  finish: 'Finish',
};

export const brush = {
  label: 'Brush',
  effect: 'Brush effect',
  kinds: {
    push: 'Push',
    pinch: 'Pinch',
    bloat: 'Bloat',
    smooth: 'Smooth',
    restore: 'Restore',
    stiffen: 'Stiffen',
  },
  tips: {
    push: 'Push: drag the picture along',
    pinch: 'Pinch: pull the picture together',
    bloat: 'Bloat: push the picture outwards',
    smooth: 'Smooth: even out brush strokes',
    restore: 'Restore: remove brush strokes',
    stiffen: 'Stiffen: keep areas rigid',
  },
  hints: {
    push: 'Drag to push the picture along.',
    pinch: 'Press or drag to pull the picture together.',
    bloat: 'Press or drag to push the picture outwards.',
    smooth: 'Drag to even out brush strokes.',
    restore: 'Drag to remove brush strokes.',
    stiffen: 'Drag over areas that should stay rigid.',
  },
  /** The effect with Alt, after the hint; empty for none. */
  altHints: {
    push: 'Alt restores.',
    pinch: 'Alt bloats.',
    bloat: 'Alt pinches.',
    smooth: '',
    restore: 'Alt pushes.',
    stiffen: 'Alt erases.',
  },
  size: 'Size',
  strength: 'Strength',
  sizeLabel: 'Brush size (%)',
  strengthLabel: 'Brush strength (%)',
  erase: 'Erase',
  eraseTip: 'Erase stiffness',
  clearStiffness: 'Clear stiffness',
  clearStiffnessTip: 'Make the whole picture soft again',
  clearStrokes: 'Clear brush strokes',
  clearStrokesTip: 'Remove all brush strokes from the picture',
  holding: 'Arrow keys push, Enter releases.',
  rigidOnly: 'Stiffness works in rigid mode only.',
  bendRigidly: 'Use rigid mode',
};

/** The line at the bottom. */
export const status = {
  label: 'Status',
  hasCreases: 'The picture has folds',
  privacy: 'Nothing leaves your browser',
  privacyTip: 'Pictures are opened, warped and saved on this device only.',
  view: 'View',
  zoom: 'Zoom',
  /** Words below icons on phones. */
  seeIt: 'Preview',
  out: 'Out',
  in: 'In',
  fit: 'Fit',
  actual: 'Actual',
  stoppedAtFold: 'Stopped at a fold',
  creases: (count: number) => counted(count, 'fold'),
  /** For screen readers. @param creases their number. @param effect of a press. */
  creasesAnd: (creases: string, effect: string) => `${creases}. ${effect}`,
  hideCreases: 'Hide the folds',
  showCreases: 'Show the folds',
  zoomToCrease: 'Zoom to the fold',
  zoomToNextCrease: 'Zoom to the next fold',
  cancel: 'Cancel',
  samples: (count: number) => counted(count, 'mesh point'),
  virtualHandles: (count: number) => counted(count, 'helper point'),
};

/** Work that takes noticeable time. */
export const tasks = {
  opening: (name: string) => `Opening ${name}`,
  /** The stages of a solve. */
  start: 'Finding the outline',
  domain: 'Building the mesh',
  sampling: 'Measuring distances',
  regions: 'Computing weights',
  weights: 'Computing weights',
  suggesting: 'Finding places for handles',
  filling: 'Filling the background',
  exporting: 'Exporting',
};
