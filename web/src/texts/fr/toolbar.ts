/** The bar at the top with its menus, and the card of tools. */
import { lowered } from '../language';
import type { Texts } from '../texts';
import { counted } from './language';

export const toolbar: Texts['toolbar'] = {
  label: 'Document',
  open: 'Ouvrir',
  save: 'Sauver',
  export: 'Exporter',
  undo: 'Annuler',
  redo: 'Rétablir',
  undoStep: (step) => `Annuler : ${lowered(step)}`,
  redoStep: (step) => `Rétablir : ${lowered(step)}`,
  compare: 'Original',
  animate: 'Animer',
  more: 'Plus',
  lightColours: 'Couleurs claires',
  darkColours: 'Couleurs sombres',
  unsaved: 'Non enregistré',
  unsavedKept: 'Non enregistré, conservé dans ce navigateur',
  noFile: 'derniers changements non enregistrés dans un fichier',
  kept: 'conservé dans ce navigateur',
};

export const files: Texts['files'] = {
  label: 'Ouvrir un travail récent, un exemple ou une adresse',
  address: 'Adresse d’une image ou d’un projet',
  placeholder: 'https://…/image.png',
  open: 'Ouvrir',
  recent: 'Travaux récents',
  removeAll: 'Tout retirer',
  noRecent: 'Les images que vous avez modifiées apparaissent ici dès que vous en ouvrez une autre.',
  remove: (name) => `Retirer de la liste : ${name}`,
  drawing: 'tracé inachevé',
  steps: (count) => counted(count, 'étape'),
  samples: 'Exemples',
  openSample: (name) => `Ouvrir l’exemple : ${name}`,
  whole: 'Tout en un fichier',
  saveWhole: 'Enregistrer avec l’image',
  exportWhole: 'Exporter un PNG modifiable',
};

/** Words below the icons on phones. */
export const tools: Texts['tools'] = {
  label: 'Outils',
  select: 'Bouger',
  point: 'Point',
  bar: 'Barre',
  polygon: 'Polygone',
  lasso: 'Lasso',
  brush: 'Pinceau',
  hand: 'Main',
  lens: 'Loupe',
  bend: 'Plier',
};
