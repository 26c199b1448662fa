/** The bar at the top with its menus, and the card of tools. */
import { lowered } from '../language';
import { counted } from './language';

export const toolbar = {
  label: 'Document',
  open: 'Open',
  save: 'Save',
  export: 'Export',
  undo: 'Undo',
  redo: 'Redo',
  /** @param step its label, such as "Move head". */
  undoStep: (step: string) => `Undo: ${lowered(step)}`,
  redoStep: (step: string) => `Redo: ${lowered(step)}`,
  compare: 'Compare',
  animate: 'Animate',
  more: 'More',
  lightColours: 'Light colours',
  darkColours: 'Dark colours',
  unsaved: 'Unsaved',
  unsavedKept: 'Unsaved, kept in this browser',
  noFile: 'no file holds the last changes',
  kept: 'kept in this browser',
};

export const files = {
  label: 'Open recent work, samples or an address',
  address: 'Address of a picture or a project',
  placeholder: 'https://…/picture.png',
  open: 'Open',
  recent: 'Recent work',
  removeAll: 'Remove all',
  noRecent: 'Pictures that you have edited are listed here once you open another.',
  /** @param name of a picture. */
  remove: (name: string) => `Remove ${name} from the list`,
  drawing: 'a drawing',
  steps: (count: number) => counted(count, 'step'),
  samples: 'Samples',
  openSample: (name: string) => `Open the sample ${name}`,
  whole: 'One file with all',
  saveWhole: 'Save with the picture',
  exportWhole: 'Export a PNG that opens again',
};

/** Words below the icons on phones. */
export const tools = {
  label: 'Tools',
  select: 'Move',
  point: 'Point',
  bar: 'Bar',
  polygon: 'Polygon',
  lasso: 'Lasso',
  brush: 'Brush',
  hand: 'Pan',
  lens: 'Lens',
  bend: 'Bend',
};
