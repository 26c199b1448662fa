/** The panel: overlays, the selected handles, how the picture bends, and the list of handles. */
import { counted, number, plural } from './language';

export const panel = {
  label: 'Properties',
  selected: 'Selected handle',
  numbers: 'Numbers',
  resetToRest: 'Reset to rest',
  restsAt: (x: number, y: number) => `Rests at ${x},\u00a0${y}`,
  name: 'Name of the handle',
  rename: (name: string) => `${name}: rename`,
  /** @param key the key of the command. */
  renameTip: (key: string) => `Rename (${key})`,
  nameFaults: { empty: 'A handle needs a name.', taken: 'Another handle has this name.' },
  /** The numbers of handles. */
  x: 'X',
  y: 'Y',
  turn: 'Turn',
  scale: 'Scale',
  depth: 'Depth',
  depthTip: (least: number, most: number) => `Drawing order, from ${least} at the back to ${most} in front`,
  automaticDepth: 'Automatic: in front of the parts that it was moved across',
  stiffness: 'Stiffness',
  stiffnessTip: 'How stiff the picture inside the polygon is, from 0 to 1',
  auto: 'Auto',
  autoTurn: 'Auto turn',
  turnsByItself: 'Turns with the picture around it',
  letTurn: 'Let it turn by itself',
  mixed: 'mixed',
  /** @param unit "px", or a range. */
  numberLabel: (label: string, unit: string) => `${label} (${unit})`,
  range: (least: number, most: number) => `${least} to ${most}`,
  /** A typed number is refused. */
  takesRange: (label: string, least: number, most: number) =>
    `${label} takes a number from ${least} to ${most}.`,
  takesNumber: (label: string) => `${label} takes a number, such as 120 or −3.5.`,
  takesUpTo: (label: string, most: number) => `${label} takes a number up to ${number(most)}.`,
  corner: (corner: number, corners: number) => `Corner ${corner} of ${corners}`,
  corners: {
    click: (count: number) => `${count} corners: double-click adds or deletes one`,
    tap: (count: number) => `${count} corners: double-tap adds or deletes one`,
  },
  cornersTip: {
    click: 'Double-click the line for one more there, a corner to delete it',
    tap: 'Double-tap the line for one more there, a corner to delete it',
  },
};

export const handleList = {
  title: 'Handles',
  suggestMore: 'Suggest more handles',
  none: {
    click:
      'None yet. Let some be suggested (N), or choose the point tool (P) and click the picture. Or draw a bar (B) or a polygon (G).',
    tap: 'None yet. Let some be suggested (N), or choose the point tool (P) and tap the picture. Or draw a bar (B) or a polygon (G).',
  },
  moved: 'moved',
  movedTip: 'Moved from its rest',
};

export const bending = {
  title: 'Bending',
  modes: { rigid: 'Rigid', harmonic: 'By hand' },
  modeNotes: {
    rigid: 'Shapes keep their form: an arm bends as an arm does.',
    harmonic: 'You turn the handles, and their motions blend, as in the paper.',
  },
  detail: 'Detail',
  details: { coarse: 'Coarse', medium: 'Medium', fine: 'Fine' },
  /** Beside the title: the chosen mode, and its detail. */
  chosen: (words: readonly string[]) => words.join(', ').toLowerCase(),
  keepWidths: 'Keep widths',
  keepWidthsNote: 'Limbs do not shrink between two turns.',
  holdBoundary: 'Hold the boundary',
  holdBoundaryNote: 'The outline stays as it is.',
  edges: 'Edges where parts cross',
  edgesNote: 'A thin shadow keeps parts of one colour apart.',
  stopAtFolds: 'Stop at folds',
  stopAtFoldsNote: 'Drags end before the picture turns over.',
  snap: 'Snap to guides',
  /** @param key the name of Ctrl, or the sign of Cmd. */
  snapNote: (key: string) => `The axis, other handles, a grid. ${key} suspends it.`,
  pixelArt: 'Pixel art',
  pixelArtNote: 'No colours are mixed.',
  allSettings: 'All settings',
  selection: 'Selection',
  selectionNote: 'Only the part inside of the lasso bends.',
  bendAll: 'Bend all of it',
  allOfIt: 'All of it',
  fill: 'Fill the background',
  fillNote: 'Where the part moves away, its surroundings go on.',
  feather: 'Feather',
  featherTip: (most: number) => `Width of the soft rim around what moves, from 0 to ${most} pixels`,
  featherNote: 'A soft rim for the moved part.',
  looseParts: 'Loose parts follow',
  loosePartsNote: (count: number) =>
    plural(count, { one: 'One part has no handle.', other: `${count} parts have no handle.` }),
};

export const overlays = {
  title: 'Overlays',
  /** @param shown the names of the overlays that are shown. */
  titleWith: (shown: readonly string[]) => `Overlays: ${shown.join(', ').toLowerCase()}`,
  close: 'Close the list',
  names: {
    mesh: 'Mesh',
    cells: 'Cells',
    sites: 'Virtual handles',
    graph: 'Cell graph',
    creases: 'Creases',
    reach: 'Reach',
    coverage: 'Coverage',
    stiffness: 'Stiffness',
    selection: 'Selection',
  },
  tips: {
    mesh: 'The triangles that the picture is drawn with',
    cells: 'The part nearest to each handle, virtual handles included',
    sites: 'Points that move the picture between your handles',
    graph: 'The neighbours among all handles, virtual ones included',
    creases: 'Places where the picture has turned over',
    reach: 'How far each place follows a small move of the selected handles',
    coverage: 'The number of handles that move each place, virtual ones included',
    stiffness: 'How stiff each place is: by the brush, and inside of stiff polygons',
    selection: 'The outline of what a lasso lets bend, and the rest dimmed',
  },
  /** The legends of heat maps: a label, and the words at both ends. */
  reachLegend: 'Blue follows a little, yellow goes along whole',
  stays: 'stays',
  goesAlong: 'goes along',
  stiffnessLegend: 'Blue is a little stiff, yellow keeps its form',
  soft: 'soft',
  stiff: 'stiff',
  coverageLegend: 'Blue is moved by few handles, yellow by many',
  coverage: (count: number) => counted(count, 'handle'),
  selectForReach: 'Select a handle to see its reach',
};
