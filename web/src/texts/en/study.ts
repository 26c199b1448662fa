/**
 * The card that explains the solution. In its sentences `r_d` and `r_h` stand for the symbols of the paper, which are
 * shown with an index.
 */
export const study = {
  title: 'See the paper',
  page: 'Page',
  pages: { lens: 'Lens', cells: 'Cells', rounds: 'Rounds', compare: 'Compare', settings: 'Settings' },
  close: 'Close',
  saveAsSvg: 'Save as SVG',
};

export const lens = {
  title: 'The weights of a point',
  point: 'Point at the picture',
  nothingBends: 'Nothing bends here',
  note: 'Every point moves by the weights of the handles around it. Arrow keys move the lens, too.',
  tap: 'Tap a point to look at it',
  click: 'Click to keep this point',
  follow: 'Follow the pointer',
  weights: 'Weights',
  weightsAt: (x: number, y: number) => `The weights at x ${x}, y ${y}`,
  noHandle: 'No handle is on this part, so it stays.',
  ownWeight: 'own weight',
  passedOn: 'passed on by virtual handles',
  virtualHandles: 'Virtual handles',
  countOfThem: (count: number) => `${count} of them`,
  virtual: (number: number) => `Virtual ${number}`,
  /** @param distance such as 12 px. @param percent such as 5 %. */
  distancePassed: (distance: string, percent: string) => `${distance}, ${percent} passed on`,
  /** For screen readers. @param shares each of a handle, or of all virtual ones. */
  spoken: (x: number, y: number, shares: readonly string[]) =>
    `x ${x}, y ${y}: ${shares.join(', ') || 'no handle moves it'}`,
  /** @param percent such as 5 %. */
  share: (handle: string, percent: string) => `${handle} ${percent}`,
  virtualShare: (percent: string) => `virtual handles ${percent}`,

  falloff: 'Falloff',
  falloffOf: (handle: string) => `Falloff of ${handle}`,
  noEnd: 'There is no other handle on this part, so its support has no end.',
  falloffLabel: (value: string, distance: string, end: string) =>
    `The falloff is ${value} at the distance of ${distance}, and ends at ${end}.`,
  /** Distances such as 12 px; null where there is none. */
  radii: (cell: string, nearest: string | null, support: string | null) =>
    `Cell r_d ${cell}${nearest === null ? '' : `, nearest other r_h ${nearest}`}${support === null ? '' : `, support r ${support}`}. Drag r in the figure, or α.`,
  distanceAxis: 'distance d inside the shape, px',
  thisPoint: (distance: string) => `this point: ${distance} →`,
};

export const cells = {
  title: 'Cells with their radii',
  none: 'There are no cells without a handle.',
  counts: (own: number, virtual: number) => `${own} cells of handles, ${virtual} of virtual handles`,
  label: 'The shape with its cells and their radii',
  farthest: 'r_d, to the farthest point of the cell',
  nearest: 'r_h, to the nearest other handle',
  note: 'A support covers its cell, and ends before the next handle of yours. So r_d must stay within the limit of r_h.',
  /** In the key of the saved figure. */
  toFarthest: 'to the farthest point of the cell',
  toNearest: 'to the nearest other site',
  times: 'Times of this solve',
  stages: {
    domain: 'Finding the outline',
    sampling: 'Sampling',
    regions: 'Distances, cells and virtual handles',
    weights: 'Weights',
    pose: 'A pose',
  },
};

/** Algorithm 1 of the paper, round by round. */
export const rounds = {
  title: 'Algorithm 1',
  figure: (round: number) => `Round ${round} of Algorithm 1`,
  none: 'There is nothing to insert without a handle.',
  play: 'Play',
  pause: 'Pause',
  previous: 'Previous round',
  next: 'Next round',
  round: 'Round',
  roundOf: (round: number, rounds: number) => `Round ${round} of ${rounds}`,
  end: (round: number, handles: number) =>
    `Round ${round}: the end. No cell is too large, and there are ${handles} handles.`,
  /** Distances such as 12 px. @param enters the sentence about the new handle. */
  tooLarge: (round: number, reach: string, allowed: string, enters: string) =>
    `Round ${round}: a cell reaches ${reach} far, and ${allowed} are allowed. ${enters}`,
  asked: (round: number, enters: string) =>
    `Round ${round}: no cell is too large, but the project asks for more virtual handles. ${enters}`,
  /** @param handle whose cell it is. @param others the number of further handles that enter. */
  enters: (handle: string, distance: string, others: number) =>
    `A virtual handle enters in the cell of ${handle}, ${distance} away${others > 0 ? `, and ${others} more elsewhere` : ''}.`,
  curve: (score: string, allowed: string) => `The score is ${score}. It may be at most ${allowed}.`,
  note: 'The score of the worst cell before each round, as in figure 3 of the paper. Below the line every support covers its cell and ends before the next handle. Rounds after that insert the virtual handles that the project asks for.',
  roundAxis: 'round',
  allowed: 'allowed',
};

export const compare = {
  title: 'One picture by three methods',
  note: 'Drag the handles of the picture. All three follow.',
  names: { paper: 'Paper', rigid: 'Rigid', plain: 'Plain distance' },
  labels: {
    paper: 'The picture by paper',
    rigid: 'The picture by rigid',
    plain: 'The picture by plain distance',
  },
  notes: {
    paper: 'Distances inside the shape, and harmonic fields. Turn the handles yourself.',
    rigid: 'The shape keeps its form as far as it can. Handles turn by themselves.',
    plain: 'As the paper, but distances cross the gaps, so near parts move along.',
  },
};

/** All settings, each with a sentence on its effect. */
export const settings = {
  motion: 'Motion of virtual handles',
  motionNotes: {
    rigid: 'They keep the form of the picture: limbs bend, and handles turn by themselves.',
    harmonic:
      'Harmonic fields mix the motions of your handles, as in the paper (eq. 4). You turn the handles.',
  },
  rigid: 'Rigid',
  byHand: 'By hand',
  density: 'Virtual handles',
  densityNote:
    'More of them bend the picture more finely, and a drag reaches less far. With 0, the paper’s algorithm decides.',
  atLeast: 'At least',
  shapeFactor: 'Support factor α',
  shapeFactorNote:
    'How far each handle reaches. At 0 it reaches little beyond its own cell, and bends are tight. At 1 it reaches as far as it may, and bends are soft.',
  support: 'Rule of supports',
  supportNotes: {
    smooth: 'Supports of virtual handles overlap. The picture bends evenly.',
    paper:
      'Supports end at the next handle, virtual ones included (eq. 3). The picture bends in smaller steps.',
  },
  smooth: 'Smooth',
  paper: 'Paper',
  continuity: 'Continuity',
  continuityNotes: {
    c2: 'Bends are smooth behind corners and around holes too: two continuous derivatives. Holes get virtual handles.',
    exact: 'The picture may show a fine crease behind a hole, where two ways around it are equally long.',
  },
  exact: 'Exact',
  degree: 'Degree n of the falloff',
  degreeNote:
    'At 5 the bend between two handles is short, and parts near them move as one. A higher degree spreads it over the way.',
  filling: 'Filling of the falloff',
  fillingNote:
    'How the falloff goes on between its ends, from degree 7 on. “Line” falls evenly. “Half” keeps a step, where parts follow two handles by halves.',
  line: 'Line',
  half: 'Half',
  blend: 'Blend',
  blendNotes: {
    rigid: 'Turns blend to turns: a part between two opposite turns keeps its size.',
    linear: 'Motions are averaged, as in the paper (eq. 1): a part between two opposite turns shrinks.',
  },
  linear: 'Linear',
  samples: 'Samples',
  samplesNote:
    'The points that carry the picture. More of them draw bends more finely, and solving takes longer.',
  points: 'Points',
  threshold: 'Least opacity',
  thresholdNote:
    'What is more transparent than this does not bend. A lower number takes soft edges and thin hair along.',
  opacity: 'Opacity',
  asInPaper: 'As in the paper',
  asInEditor: 'As in the editor',
};
