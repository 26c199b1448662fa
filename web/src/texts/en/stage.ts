/** The stage: its labels, hints, drawings, the brush, and the line below it. */
import { counted } from './language';

export const stage = {
  keys: 'Arrow keys move the selection. Comma and full stop turn it, and with Alt scale it.',
  noPicture: 'No picture',
  picture: (name: string) => `Picture ${name}`,
  /** @param picture the label of the picture. */
  disabled: (picture: string) => `${picture}, disabled`,
  posable: (picture: string) => `${picture}, to be posed by its handles`,
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
  selectionCornerKeys: 'Arrow keys move it. Delete removes it, and C adds one after it.',
  /** The menu of a place of the picture. */
  pictureMenu: 'Picture',
  /** @param handle its name. */
  cornerMenu: (corner: number, handle: string) => `Corner ${corner} of ${handle}`,
};

export const hints = {
  bar: { click: 'Drag a bar, or click its corners', tap: 'Drag a bar, or tap its corners' },
  polygon: { click: 'Draw a polygon: click its corners', tap: 'Draw a polygon: tap its corners' },
  lasso: {
    click: 'Draw around the part that bends: drag, or click corners',
    tap: 'Draw around the part that bends: drag, or tap corners',
  },
  lassoAgain: 'Drag a corner of the selection, or draw around another part',
  select: {
    click: 'Take the point tool, and click the picture',
    tap: 'Take the point tool, and tap the picture',
  },
  point: {
    click: 'Click the picture where you want to hold it',
    tap: 'Tap the picture where you want to hold it',
  },
  snapToEdges: 'Snap to edges',
  snapToEdgesTip: 'The lasso follows edges of the picture. Hold Alt to draw freely',
};

export const drawing = {
  label: 'Drawing',
  ready: 'Add corners, or finish',
  oneMore: 'One corner more',
  more: (count: number) => `${count} corners more`,
  takeBack: 'Take back the last corner',
  giveUp: 'Give up drawing',
  finish: 'Finish',
};

export const brush = {
  label: 'Brush',
  effect: 'Effect of the brush',
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
    pinch: 'Pinch: draw the picture together',
    bloat: 'Bloat: spread the picture out',
    smooth: 'Smooth: level places that the brush has moved',
    restore: 'Restore: take back strokes of the brush',
    stiffen: 'Stiffen: keep the form of places',
  },
  hints: {
    push: 'Drag to push the picture along.',
    pinch: 'Press or drag to draw the picture together.',
    bloat: 'Press or drag to spread the picture out.',
    smooth: 'Drag to level places that the brush has moved.',
    restore: 'Drag to take back strokes of the brush.',
    stiffen: 'Drag over places that are to keep their form.',
  },
  /** The effect with Alt, after the hint; empty for none. */
  altHints: {
    push: 'Alt restores it.',
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
  clearStiffnessTip: 'Make the picture soft again',
  clearStrokes: 'Clear the strokes of the brush',
  clearStrokesTip: 'Take back all that the brush has moved',
  holding: 'Arrows push, Enter lets go.',
  rigidOnly: 'Stiffness counts in rigid bending only.',
  bendRigidly: 'Bend rigidly',
};

/** The line at the bottom. */
export const status = {
  label: 'Status',
  hasCreases: 'The picture has creases',
  privacy: 'Nothing leaves your browser',
  privacyTip: 'Pictures are opened, warped and saved on this machine only.',
  view: 'View',
  zoom: 'Zoom',
  /** Words below icons on phones. */
  seeIt: 'See it',
  out: 'Out',
  in: 'In',
  fit: 'Fit',
  actual: 'Actual',
  stoppedAtFold: 'Stopped at a fold',
  creases: (count: number) => counted(count, 'crease'),
  /** For screen readers. @param creases their number. @param effect of a press. */
  creasesAnd: (creases: string, effect: string) => `${creases}. ${effect}`,
  hideCreases: 'Hide the creases',
  showCreases: 'Show the creases',
  zoomToCrease: 'Zoom to the crease',
  zoomToNextCrease: 'Zoom to the next crease',
  cancel: 'Cancel',
  samples: (count: number) => counted(count, 'sample'),
  virtualHandles: (count: number) => counted(count, 'virtual handle'),
};

/** Work that takes noticeable time. */
export const tasks = {
  opening: (name: string) => `Opening ${name}`,
  /** The stages of a solve. */
  start: 'Finding the outline',
  domain: 'Sampling',
  sampling: 'Measuring distances',
  regions: 'Weighting',
  weights: 'Weighting',
  suggesting: 'Looking for places for handles',
  filling: 'Filling the background',
  exporting: 'Exporting',
};
