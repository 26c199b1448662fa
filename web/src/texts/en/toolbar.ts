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
  noFile: 'latest changes not saved to a file',
  kept: 'kept in this browser',
};

export const files = {
  label: 'Open recent work, a sample or an address',
  address: 'Address of a picture or project',
  placeholder: 'https://…/picture.png',
  open: 'Open',
  recent: 'Recent work',
  removeAll: 'Remove all',
  noRecent: 'Edited pictures appear here after you open another one.',
  /** @param name of a picture. */
  remove: (name: string) => `Remove ${name} from the list`,
  drawing: 'unfinished drawing',
  steps: (count: number) => counted(count, 'step'),
  samples: 'Samples',
  openSample: (name: string) => `Open the sample ${name}`,
  whole: 'All in one file',
  saveWhole: 'Save with the picture',
  exportWhole: 'Export an editable PNG',
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
