/**
 * The panel that explains the solution. In its sentences `r_d` and `r_h` stand for the symbols of the paper, which are
 * shown with an index.
 */
import { counted } from './language';

export const study = {
  title: 'How the warp works',
  page: 'Page',
  pages: { lens: 'Lens', cells: 'Cells', rounds: 'Rounds', compare: 'Compare', settings: 'Settings' },
  close: 'Close',
  saveAsSvg: 'Save as SVG',
};

export const lens = {
  title: 'Weights at a point',
  point: 'Choose a point',
  nothingBends: 'Nothing bends here',
  note: 'Each point follows the handles around it according to their weights. You can also move the lens with the arrow keys.',
  tap: 'Tap a point to inspect it',
  click: 'Click to pin this point',
  follow: 'Follow the pointer',
  weights: 'Weights',
  weightsAt: (x: number, y: number) => `The weights at x ${x}, y ${y}`,
  noHandle: 'This part has no handle, so it stays in place.',
  ownWeight: 'direct weight',
  passedOn: 'indirect weight, through helper points',
  virtualHandles: 'Helper points',
  countOfThem: (count: number) => counted(count, 'point'),
  virtual: (number: number) => `Helper ${number}`,
  /** @param distance such as 12 px. @param percent such as 5 %. */
  distancePassed: (distance: string, percent: string) => `${distance}, ${percent} indirect`,
  /** For screen readers. @param shares each of a handle, or of all virtual ones. */
  spoken: (x: number, y: number, shares: readonly string[]) =>
    `x ${x}, y ${y}: ${shares.join(', ') || 'no handle moves it'}`,
  /** @param percent such as 5 %. */
  share: (handle: string, percent: string) => `${handle} ${percent}`,
  virtualShare: (percent: string) => `helper points ${percent}`,

  falloff: 'Falloff',
  falloffOf: (handle: string) => `Falloff of ${handle}`,
  noEnd: 'This is the only handle on its part, so its support has no end.',
  falloffLabel: (value: string, distance: string, end: string) =>
    `The falloff is ${value} at a distance of ${distance}, and ends at ${end}.`,
  /** Distances such as 12 px; null where there is none. */
  radii: (cell: string, nearest: string | null, support: string | null) =>
    `Cell radius r_d ${cell}${nearest === null ? '' : `, nearest neighbour r_h ${nearest}`}${support === null ? '' : `, support r ${support}`}. Drag r in the figure, or set α.`,
  distanceAxis: 'distance d inside the shape, px',
  thisPoint: (distance: string) => `this point: ${distance} →`,
};

export const cells = {
  title: 'Cells and their radii',
  none: 'Add a handle to see its cell.',
  counts: (own: number, virtual: number) => `Cells: ${own} of handles, ${virtual} of helper points`,
  label: 'The shape with its cells and their radii',
  farthest: 'r_d, to the farthest point of the cell',
  nearest: 'r_h, to the nearest neighbour',
  note: 'A support covers its cell and ends before your next handle. So r_h limits r_d. The paper calls helper points “virtual handles”.',
  /** In the key of the saved figure. */
  toFarthest: 'to the farthest point of the cell',
  toNearest: 'to the nearest neighbour',
  times: 'Computing time by stage',
  stages: {
    domain: 'Finding the outline',
    sampling: 'Building the mesh',
    regions: 'Distances, cells and helper points',
    weights: 'Weights',
    pose: 'Posing',
  },
};

/** Algorithm 1 of the paper, round by round. */
export const rounds = {
  title: 'Algorithm 1',
  figure: (round: number) => `Round ${round} of Algorithm 1`,
  none: 'Add a handle to run the algorithm.',
  play: 'Play',
  pause: 'Pause',
  previous: 'Previous round',
  next: 'Next round',
  round: 'Round',
  roundOf: (round: number, rounds: number) => `Round ${round} of ${rounds}`,
  end: (round: number, handles: number) =>
    `Round ${round}: done. No cell is too large, with ${handles} handles and helper points in all.`,
  /** Distances such as 12 px. @param enters the sentence about the new helper point. */
  tooLarge: (round: number, reach: string, allowed: string, enters: string) =>
    `Round ${round}: a cell reaches ${reach}, beyond the limit of ${allowed}. ${enters}`,
  asked: (round: number, enters: string) =>
    `Round ${round}: no cell is too large, but the project asks for more helper points. ${enters}`,
  /** @param handle whose cell it is. @param others the number of further helper points. */
  enters: (handle: string, distance: string, others: number) =>
    `A helper point enters the cell of ${handle}, ${distance} away${others > 0 ? `, and ${others} more enter elsewhere` : ''}.`,
  curve: (score: string, allowed: string) => `The score is ${score}. The limit is ${allowed}.`,
  note: 'The score of the worst cell before each round, as in figure 3 of the paper. Below the line, every support covers its cell and ends before the next handle. Later rounds add the helper points that the project asks for.',
  roundAxis: 'round',
  allowed: 'limit',
};

export const compare = {
  title: 'One picture, three methods',
  note: 'Drag the handles of the picture. All three follow.',
  names: { paper: 'Paper', rigid: 'Rigid', plain: 'Plain distance' },
  labels: {
    paper: 'The picture warped as in the paper',
    rigid: 'The picture warped in rigid mode',
    plain: 'The picture warped with plain distances',
  },
  notes: {
    paper: 'Distances inside the shape, and harmonic fields. You turn the handles yourself.',
    rigid: 'Parts keep their shape as far as possible. Handles turn automatically.',
    plain: 'Like the paper, but distances cross gaps, so nearby parts move too.',
  },
};

/** All settings, each with a sentence on its effect. */
export const settings = {
  motion: 'Motion of helper points',
  motionNotes: {
    rigid: 'They keep the shape of the picture: limbs bend, and handles turn automatically.',
    harmonic:
      'Harmonic fields blend the motions of your handles, as in the paper (eq. 4). You turn the handles yourself.',
  },
  rigid: 'Rigid',
  byHand: 'Elastic',
  density: 'Helper points',
  densityNote:
    'More points bend the picture more finely, and a drag reaches less far. At 0, the paper’s algorithm decides.',
  atLeast: 'At least',
  shapeFactor: 'Support factor α',
  shapeFactorNote:
    'How far each handle reaches. At 0, it reaches little beyond its own cell, and bends are tight. At 1, it reaches as far as possible, and bends are soft.',
  support: 'Support rule',
  supportNotes: {
    smooth: 'Supports of helper points overlap, so the picture bends evenly.',
    paper: 'Supports end at the next handle or helper point (eq. 3), so the picture bends in smaller steps.',
  },
  smooth: 'Smooth',
  paper: 'Paper',
  continuity: 'Continuity',
  continuityNotes: {
    c2: 'Bends are smooth even behind corners and around holes: two derivatives are continuous. Holes get helper points.',
    exact: 'A fine crease may appear behind a hole, where two ways around it are equally long.',
  },
  exact: 'Exact',
  degree: 'Falloff degree n',
  degreeNote:
    'At 5, the bend between two handles is short, and the picture near each handle moves as one. A higher degree spreads the bend out.',
  filling: 'Falloff shape',
  fillingNote:
    'The course of the falloff between its ends, from degree 7 up. “Line” falls evenly. “Half” has a plateau, where the picture follows two handles equally.',
  line: 'Line',
  half: 'Half',
  blend: 'Blend',
  blendNotes: {
    rigid: 'Turns blend into turns: a part between two opposite turns keeps its size.',
    linear: 'Motions are averaged, as in the paper (eq. 1): a part between two opposite turns shrinks.',
  },
  linear: 'Linear',
  samples: 'Mesh points',
  samplesNote:
    'The corners of the mesh that carries the picture. More points draw bends more finely, but solving takes longer.',
  points: 'Points',
  threshold: 'Minimum opacity',
  thresholdNote:
    'Pixels more transparent than this do not bend. A lower number includes soft edges and thin hair.',
  opacity: 'Opacity',
  asInPaper: 'Paper defaults',
  asInEditor: 'Editor defaults',
};
