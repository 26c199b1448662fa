/** Errors of the solver and its worker. */

/** Why something is more than the solver can do, mostly for want of memory. */
export const tooMuchErrors = {
  picture: 'The picture needs more memory than there is: scale it down.',
  pictures: 'The pictures need more memory than there is: scale them down.',
  suggest: 'The picture needs more memory than there is to suggest handles: scale it down.',
  solve: 'This is more than the solver can do with the memory that there is.',
  fill: 'The picture needs more memory than there is to fill the background: scale it down.',
  draw: 'The picture needs more memory to be drawn than there is.',
  film: 'The film needs more memory to be drawn than this browser gives.',
  points: 'The points need more memory than there is.',
  cells: 'The cells are more than the solver can do in this browser.',
  study: 'The figures are more than the solver can do in this browser.',
  lens: 'The lens is more than the solver can do in this browser.',
  rig: 'The clips are more than a rig can hold in this browser: shorten them.',
  map: 'The file is more than this browser can hold: the command line writes it.',
  drawing: 'The drawing is more than this browser can bend: simplify it.',
};

export const engineErrors = {
  /** @param why one of the following four, or a message of the browser. */
  notLoaded: (why: string) => `The solver could not be loaded: ${why}`,
  exportNotLoaded: (why: string) => `The export could not be started: ${why}`,
  status: (address: string, status: number) => `${address} answers ${status}`,
  isPage: (address: string) => `${address} is not there: a page is, in its place`,
  absent: (address: string) => `${address} does not come: is the network there, and does the page allow it?`,
  incomplete: (address: string, detail: string) =>
    `${address} came incomplete, or cannot run here (${detail}).`,
  noWorkers: 'The solver could not be started: this browser or this page does not allow workers.',
  notStarted: (address: string) =>
    `The solver failed: its worker could not be started: is ${address} there, and does the page allow it?`,
  exportNotStarted: (address: string) =>
    `The export could not be started: is ${address} there, and does the page allow workers?`,
  lostDrawing: 'The solver failed during the drawing.',
  released: 'The pixels of the picture are gone, or there is no memory for them. Open the picture again.',
};

/**
 * Refusals of the solver, by their codes. English shows the words of the solver for most of them.
 *
 * @param detail the words of the solver, in English. They may name keys of project files.
 * @param name of the handle that is to blame, or empty. @param other of a second one.
 */
type Refusal = (detail: string, name: string, other: string) => string;
const asIs: Refusal = (detail) => detail;
const refusal = (words: Refusal): Refusal => words;

export const refusals = {
  /** A project file that is not valid: the detail says where. */
  project: asIs,
  /** A picture with a side that is too short or too long. */
  picture: asIs,
  /** The project is for a picture of another size. */
  'picture-mismatch': asIs,
  scale: refusal(() => 'The export would be too large or too small: choose another size.'),
  canvas: refusal(
    () => 'All of the picture would be too large: choose a smaller size, or the rectangle of the original.',
  ),
  'nothing-drawn': refusal(() => 'Nothing is covered: the picture is transparent everywhere.'),
  /** No pixel is opaque enough, by the setting "Least opacity". */
  'nothing-opaque': asIs,
  'nothing-to-fill-from': refusal(
    () =>
      'Nothing is left around the selection to fill its background from: draw a smaller one, or leave it empty.',
  ),
  /** The picture has no transparent part, and so no outline that a rig could be fitted to. */
  'no-outline': asIs,
  /** A ring of a selection is not valid: outside the picture, crossing itself, flat, or with too many corners. */
  domain: asIs,
  'handle-outside': refusal((_, name) => `“${name}” lies outside the shape: place it on the picture.`),
  'handle-far-outside': refusal(
    (_, name) => `“${name}” would lie far outside this picture: the rig does not fit it.`,
  ),
  /** Two handles at the same place: `name` and `other`. Move or delete one. */
  'handles-too-close': asIs,
  /** Two corners of `name` are at the same place. Move or delete one. */
  'bar-too-short': asIs,
  'bars-overlap': refusal((_, name, other) =>
    name === other
      ? `“${name}” runs back along itself: its pieces may cross and touch, but not lie on one another.`
      : `“${name}” and “${other}” run along each other: they may cross and touch, but not lie on one another.`,
  ),
  'on-held-boundary': refusal(
    (_, name) =>
      `“${name}” stands on the boundary, which is held: move it further inside, or free the boundary.`,
  ),
  /** More handles than the solver supports. */
  'too-many-handles': asIs,
  'handles-crowded': refusal(
    () => 'Too many handles stand very close to one another: move some apart, or delete them.',
  ),
  'outline-too-long': refusal(
    () => 'This outline has too many slits and spikes: draw a simpler one, or a coarser one around it.',
  ),
  /** Bars and polygons have more corners than the solver supports: draw `name` with fewer. */
  'too-many-corners': asIs,
  'too-many-sites': refusal(
    () => 'The handles are too close to one another, or too many: move some apart, or use less detail.',
  ),
  'too-much-memory': refusal(
    () => 'This needs more memory than a browser has: use fewer handles, or less detail.',
  ),
  'too-much-work': refusal(
    () => 'This is too intricate to solve in a few seconds: use fewer handles, or a simpler outline.',
  ),
  'held-too-fine': refusal(
    () => 'This outline has too many corners to be held: draw a simpler one, or let it move.',
  ),
  /** A setting of the project is not supported: the detail says which. */
  unsupported: asIs,
  /** A pose has numbers that are too large, or does not belong to the solution. */
  pose: asIs,
  /** A film would have too many frames, or an invalid rate or part: lower the rate, or show a part of the clip. */
  film: asIs,
  'point-outside': asIs,
  mesh: asIs,
  cloud: asIs,
  poser: asIs,
};
