/** Texts for screen readers: labels of handles, and announcements. */
import { plural } from './language';

const rotation = (degrees: number): string =>
  `rotation ${degrees} ${plural(Math.abs(degrees), { one: 'degree', other: 'degrees' })}`;

const says = (name: string, kind: string): boolean => name.toLowerCase().split(' ').includes(kind);

export const spoken = {
  /** A point, by its name, which may say its kind already. */
  point: (name: string) => (says(name, 'handle') || says(name, 'point') ? name : `Handle ${name}`),
  bar: (name: string, corners: number) =>
    says(name, 'bar') ? `${name}, with ${corners} corners` : `Handle ${name}, bar with ${corners} corners`,
  polygon: (name: string, corners: number) =>
    says(name, 'polygon')
      ? `${name}, with ${corners} corners`
      : `Handle ${name}, polygon with ${corners} corners`,
  x: (x: number) => `x ${x}`,
  y: (y: number) => `y ${y}`,
  rotation,
  scale: (scale: number) => `scale ${scale}`,
  depth: (depth: number) => `depth ${depth}`,
  behind: 'behind another part',
  corner: (corner: number, handle: string, x: number, y: number) =>
    `Corner ${corner} of ${handle}, x ${x}, y ${y}`,

  /** The pose of handles. @param scale null where it is 1, or where they differ. */
  place: (handles: string, x: number, y: number, degrees: number, scale: number | null) =>
    `${handles}: x ${x}, y ${y}, ${rotation(degrees)}${scale === null ? '' : `, scale ${scale}`}`,
  /** @param time such as 1.00 s. */
  time: (time: string) => time,
  at: (x: number, y: number) => `x ${x}, y ${y}`,
  cornerAt: (corner: number, handle: string, x: number, y: number) =>
    `Corner ${corner} of ${handle}: x ${x}, y ${y}`,
  selectionCornerAt: (corner: number, x: number, y: number) =>
    `Corner ${corner} of the selection: x ${x}, y ${y}`,
  depthOf: (handle: string, depth: number) => `${handle}: depth ${depth}`,
  depthInFront: (handle: string, depth: number) => `${handle}: depth ${depth}, in front`,
  depthAtBack: (handle: string, depth: number) => `${handle}: depth ${depth}, at the back`,
  draft: {
    bar: (corner: number, x: number, y: number) => `bar, corner ${corner}: x ${x}, y ${y}`,
    polygon: (corner: number, x: number, y: number) => `polygon, corner ${corner}: x ${x}, y ${y}`,
    lasso: (corner: number, x: number, y: number) => `lasso, corner ${corner}: x ${x}, y ${y}`,
  },
  drawingGivenUp: 'Drawing cancelled',
  /** @param step its label. @param place of the handles after it. */
  stepAt: (step: string, place: string) => `${step}. ${place}`,
  undone: (step: string) => `Undone: ${step}`,
  redone: (step: string) => `Redone: ${step}`,
  selected: (handles: string) => `Selected ${handles}`,
  copiedPose: (handles: string) => `Copied the pose of ${handles}`,
  cancelled: 'Cancelled',
  stoppedAtFold: 'Stopped before the picture folds',
  held: 'Grabbed. Arrow keys push, Enter releases',
  cornerCrosses: 'The outline would cross itself',
  cornerStays: 'The outline needs this corner',
  brushSize: (percent: number) => `Brush size ${percent} percent`,
  brush: {
    push: 'Brush: push',
    pinch: 'Brush: pinch',
    bloat: 'Brush: bloat',
    smooth: 'Brush: smooth',
    restore: 'Brush: restore',
    stiffen: 'Brush: stiffen',
    paints: 'Brush: paint stiffness',
    erases: 'Brush: erase stiffness',
  },
  pictureOpen: (name: string) => `${name} is open`,
  /** @param tool its command. */
  toolAndPicture: (tool: string, picture: string) => `${tool}, ${picture} is open`,
  timelineOpen: 'Timeline',
  timelineClosed: 'Timeline closed',
  exporting: (percent: number) => `Exporting, ${percent} percent`,
  exportCancelled: 'Export cancelled',
};
