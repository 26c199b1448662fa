/** Errors of the solver and its worker. */

/** Why something is too much for the solver, mostly for lack of memory. */
export const tooMuchErrors = {
  picture: 'The picture is too large for memory. Scale it down.',
  pictures: 'The pictures are too large for memory. Scale them down.',
  suggest: 'Not enough memory to suggest handles. Scale the picture down.',
  solve: 'Not enough memory for this warp. Use fewer handles, or less detail.',
  fill: 'Not enough memory to fill the background. Scale the picture down.',
  draw: 'Not enough memory to draw the picture. Choose a smaller size.',
  film: 'Not enough memory in this browser to draw the film. Choose a smaller size.',
  points: 'Not enough memory for so many points.',
  cells: 'Not enough memory in this browser to compute the cells.',
  study: 'Not enough memory in this browser to compute the figures.',
  lens: 'Not enough memory in this browser for the lens.',
  rig: 'The clips are too long for a rig in this browser. Shorten them.',
  map: 'The file is too large for this browser. Use the command line instead.',
  drawing: 'The drawing is too complex to bend in this browser. Simplify it.',
};

export const engineErrors = {
  /** @param why one of the following four, or a message of the browser. */
  notLoaded: (why: string) => `Could not load the solver: ${why}`,
  exportNotLoaded: (why: string) => `Could not start the export: ${why}`,
  status: (address: string, status: number) => `the server answered ${status} for ${address}.`,
  isPage: (address: string) => `the server sent a web page instead of ${address}.`,
  absent: (address: string) =>
    `${address} is out of reach. Check your connection and the security policy of the page.`,
  incomplete: (address: string, detail: string) =>
    `${address} is incomplete, or cannot run here (${detail}).`,
  noWorkers: 'Could not start the solver: this browser or this page does not allow workers.',
  notStarted: (address: string) =>
    `Could not start the solver. Check that ${address} exists and that the page allows workers.`,
  exportNotStarted: (address: string) =>
    `Could not start the export. Check that ${address} exists and that the page allows workers.`,
  drawingNotChecked:
    'This drawing needs a part of the editor that could not be loaded. Check your connection, and that the page allows workers.',
  lostDrawing: 'The solver failed while drawing.',
  released: 'The pixels of the picture are no longer in memory. Open the picture again.',
};

/**
 * Refusals of the solver, by their codes. English shows the words of the solver for some of them.
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
  scale: refusal(() => 'The export would be too large or too small. Choose another size.'),
  canvas: refusal(
    () => 'The expanded picture would be too large. Choose a smaller size, or the original frame.',
  ),
  'nothing-drawn': refusal(() => 'The picture is transparent everywhere.'),
  'nothing-opaque': refusal(
    () => 'No part of the picture is opaque enough to warp. Lower the setting “Minimum opacity”.',
  ),
  'nothing-to-fill-from': refusal(
    () =>
      'The selection leaves nothing to fill the background from. Draw a smaller one, or turn the fill off.',
  ),
  'no-outline': refusal(() => 'The picture has no transparent part, so it has no outline to fit a rig to.'),
  /** A ring of a selection is not valid: outside the picture, crossing itself, flat, or with too many corners. */
  domain: asIs,
  'handle-outside': refusal((_, name) => `“${name}” lies outside the shape. Place it on the picture.`),
  'handle-far-outside': refusal(
    (_, name) => `This rig does not fit the picture: “${name}” would lie far outside.`,
  ),
  'handles-too-close': refusal(
    (_, name, other) => `“${name}” and “${other}” are in the same place. Move or delete one of them.`,
  ),
  'bar-too-short': refusal(
    (_, name) => `Two corners of “${name}” are in the same place. Move or delete one of them.`,
  ),
  'bars-overlap': refusal((_, name, other) =>
    name === other
      ? `“${name}” runs back along itself. Its pieces may cross or touch, but not overlap along a line.`
      : `“${name}” and “${other}” run along each other. They may cross or touch, but not overlap along a line.`,
  ),
  'on-held-boundary': refusal(
    (_, name) => `“${name}” lies on the locked outline. Move it further inside, or unlock the outline.`,
  ),
  'too-many-handles': refusal(() => 'There are too many handles. Delete some.'),
  'handles-crowded': refusal(
    () => 'Too many handles are very close together. Move some apart, or delete some.',
  ),
  'outline-too-long': refusal(
    () => 'This outline has too many slits and spikes. Draw a simpler one, or a coarser one around it.',
  ),
  'too-many-corners': refusal(
    (_, name) => `Bars and polygons have too many corners. Draw ${name ? `“${name}”` : 'them'} with fewer.`,
  ),
  'too-many-sites': refusal(
    () => 'The handles are too many or too close together. Move some apart, or use less detail.',
  ),
  'too-much-memory': refusal(
    () => 'This warp needs too much memory for a browser. Use fewer handles, or less detail.',
  ),
  'too-much-work': refusal(
    () => 'This warp is too complex to solve in a few seconds. Use fewer handles, or a simpler outline.',
  ),
  'held-too-fine': refusal(
    () => 'This outline has too many corners to lock. Draw a simpler one, or unlock the outline.',
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
