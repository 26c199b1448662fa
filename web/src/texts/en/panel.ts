/** The panel: overlays, the selected handles, how the picture bends, and the list of handles. */
import { counted, number, plural } from './language';

export const panel = {
  label: 'Properties',
  selected: 'Selected handle',
  numbers: 'Values',
  resetToRest: 'Reset to rest position',
  restsAt: (x: number, y: number) => `Rest position ${x},\u00a0${y}`,
  name: 'Handle name',
  rename: (name: string) => `Rename ${name}`,
  /** @param key the key of the command. */
  renameTip: (key: string) => `Rename (${key})`,
  nameFaults: { empty: 'A handle needs a name.', taken: 'Another handle has this name.' },
  /** The numbers of handles. */
  x: 'X',
  y: 'Y',
  turn: 'Rotation',
  scale: 'Scale',
  depth: 'Depth',
  depthTip: (least: number, most: number) => `Drawing order, from ${least} (back) to ${most} (front)`,
  automaticDepth: 'Automatic: in front of the parts that it was moved across',
  stiffness: 'Stiffness',
  stiffnessTip: 'How stiff the picture is inside the polygon, from 0 to 1',
  auto: 'Auto',
  autoTurn: 'Auto rotation',
  turnsByItself: 'Turns with the picture around it',
  letTurn: 'Turn automatically',
  mixed: 'mixed',
  /** @param unit "px", or a range. */
  numberLabel: (label: string, unit: string) => `${label} (${unit})`,
  range: (least: number, most: number) => `${least} to ${most}`,
  /** A typed number is refused. */
  takesRange: (label: string, least: number, most: number) =>
    `${label}: enter a number from ${least} to ${most}.`,
  takesNumber: (label: string) => `${label}: enter a number, such as 120 or −3.5.`,
  takesUpTo: (label: string, most: number) => `${label}: enter a number up to ${number(most)}.`,
  corner: (corner: number, corners: number) => `Corner ${corner} of ${corners}`,
  corners: {
    click: (count: number) => `${count} corners. Double-click to add or delete one.`,
    tap: (count: number) => `${count} corners. Double-tap to add or delete one.`,
  },
  cornersTip: {
    click: 'Double-click the line to add a corner, or a corner to delete it',
    tap: 'Double-tap the line to add a corner, or a corner to delete it',
  },
};

export const handleList = {
  title: 'Handles',
  suggestMore: 'Suggest more handles',
  none: {
    click:
      'No handles yet. Press N to suggest some, or choose the point tool (P) and click the picture. You can also draw a bar (B) or a polygon (G).',
    tap: 'No handles yet. Let the editor suggest some, or choose the point tool and tap the picture. You can also draw a bar or a polygon.',
  },
  moved: 'moved',
  movedTip: 'Moved from its rest position',
};

export const bending = {
  title: 'Bending',
  modes: { rigid: 'Rigid', harmonic: 'Elastic' },
  modeNotes: {
    rigid: 'Parts keep their shape: an arm bends like a real arm.',
    harmonic: 'The picture stretches smoothly between handles. You turn each handle yourself.',
  },
  detail: 'Detail',
  details: { coarse: 'Coarse', medium: 'Medium', fine: 'Fine' },
  /** Beside the title: the chosen mode, and its detail. */
  chosen: (words: readonly string[]) => words.join(', ').toLowerCase(),
  keepWidths: 'Keep widths',
  keepWidthsNote: 'Limbs do not get thinner between turned handles.',
  holdBoundary: 'Lock the outline',
  holdBoundaryNote: 'Bending does not move the outline.',
  edges: 'Shadow where parts overlap',
  edgesNote: 'A thin shadow separates parts of the same colour.',
  stopAtFolds: 'Stop at folds',
  stopAtFoldsNote: 'Drags stop before the picture folds over.',
  snap: 'Snap to guides',
  /** @param key the name of Ctrl, or the sign of Cmd. */
  snapNote: (key: string) => `Snaps to the symmetry axis, handles and a grid. Hold ${key} to ignore them.`,
  pixelArt: 'Pixel art',
  pixelArtNote: 'Pixels stay sharp. Colours do not blend.',
  allSettings: 'All settings',
  selection: 'Selection',
  selectionNote: 'Only the part inside the lasso bends.',
  bendAll: 'Remove the selection',
  allOfIt: 'Remove',
  fill: 'Fill the background',
  fillNote: 'The background fills the gap where the part moves away.',
  feather: 'Feather',
  featherTip: (most: number) => `Width of the soft edge around the moved part, from 0 to ${most} pixels`,
  featherNote: 'A soft edge around the moved part.',
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
    sites: 'Helper points',
    graph: 'Cell graph',
    creases: 'Folds',
    reach: 'Reach',
    coverage: 'Coverage',
    stiffness: 'Stiffness',
    selection: 'Selection',
  },
  tips: {
    mesh: 'The triangles that make up the picture',
    cells: 'The area closest to each handle or helper point',
    sites: 'Automatic points that move the picture between your handles',
    graph: 'Links between neighbouring handles and helper points',
    creases: 'Areas where the picture folds over',
    reach: 'How closely each area follows the selected handles',
    coverage: 'How many handles and helper points move each area',
    stiffness: 'How stiff each area is, from the brush and stiff polygons',
    selection: 'The outline of the lasso selection, with the rest dimmed',
  },
  /** The legends of heat maps: a label, and the words at both ends. */
  reachLegend: 'Blue follows slightly, yellow follows fully',
  stays: 'stays',
  goesAlong: 'follows',
  stiffnessLegend: 'Blue is slightly stiff, yellow keeps its shape',
  soft: 'soft',
  stiff: 'stiff',
  coverageLegend: 'Few points move blue areas, many points move yellow areas',
  coverage: (count: number) => counted(count, 'point'),
  selectForReach: 'Select a handle to see its reach',
};
