import type { Texts } from '../texts';
import { counted } from './language';

export const toolbar: Texts['toolbar'] = {
  label: 'Dokument',
  open: 'Öffnen',
  save: 'Sichern',
  export: 'Export',
  undo: 'Rückgängig',
  redo: 'Wiederholen',
  undoStep: (step) => `Rückgängig: ${step}`,
  redoStep: (step) => `Wiederholen: ${step}`,
  compare: 'Original',
  animate: 'Animieren',
  more: 'Mehr',
  lightColours: 'Helle Farben',
  darkColours: 'Dunkle Farben',
  unsaved: 'Ungespeichert',
  unsavedKept: 'Ungespeichert, in diesem Browser aufbewahrt',
  noFile: 'letzte Änderungen nicht als Datei gespeichert',
  kept: 'in diesem Browser aufbewahrt',
};

export const files: Texts['files'] = {
  label: 'Letzte Arbeit, Beispiel oder Adresse öffnen',
  address: 'Adresse eines Bilds oder Projekts',
  placeholder: 'https://…/bild.png',
  open: 'Öffnen',
  recent: 'Letzte Arbeiten',
  removeAll: 'Alle entfernen',
  noRecent: 'Bearbeitete Bilder erscheinen hier, sobald Sie ein anderes öffnen.',
  remove: (name) => `${name} aus der Liste entfernen`,
  drawing: 'unfertige Zeichnung',
  steps: (count) => counted(count, 'Schritt', 'Schritte'),
  samples: 'Beispiele',
  openSample: (name) => `Beispiel öffnen: ${name}`,
  whole: 'Alles in einer Datei',
  saveWhole: 'Mit dem Bild speichern',
  exportWhole: 'Bearbeitbares PNG exportieren',
};

export const tools: Texts['tools'] = {
  label: 'Werkzeuge',
  select: 'Ziehen',
  point: 'Punkt',
  bar: 'Stab',
  polygon: 'Polygon',
  lasso: 'Lasso',
  brush: 'Pinsel',
  hand: 'Hand',
  lens: 'Lupe',
  bend: 'Biegen',
};
