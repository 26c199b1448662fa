/** The bar at the top with its menus, and the card of tools. */
import { lowered } from '../language';
import type { Texts } from '../texts';
import { counted } from './language';

export const toolbar: Texts['toolbar'] = {
  label: 'Documento',
  open: 'Abrir',
  save: 'Guardar',
  export: 'Exportar',
  undo: 'Deshacer',
  redo: 'Rehacer',
  undoStep: (step) => `Deshacer: ${lowered(step)}`,
  redoStep: (step) => `Rehacer: ${lowered(step)}`,
  compare: 'Original',
  animate: 'Animar',
  more: 'Más',
  lightColours: 'Colores claros',
  darkColours: 'Colores oscuros',
  unsaved: 'Sin guardar',
  unsavedKept: 'Sin guardar, conservado en este navegador',
  noFile: 'ningún archivo contiene los últimos cambios',
  kept: 'conservado en este navegador',
};

export const files: Texts['files'] = {
  label: 'Abrir trabajos recientes, ejemplos o una dirección',
  address: 'Dirección de una imagen o un proyecto',
  placeholder: 'https://…/imagen.png',
  open: 'Abrir',
  recent: 'Trabajos recientes',
  removeAll: 'Quitar todo',
  noRecent: 'Las imágenes editadas aparecen aquí al abrir otra.',
  remove: (name) => `Quitar ${name} de la lista`,
  drawing: 'un dibujo',
  steps: (count) => counted(count, 'paso', 'pasos'),
  samples: 'Ejemplos',
  openSample: (name) => `Abrir el ejemplo ${name}`,
  whole: 'Un archivo con todo',
  saveWhole: 'Guardar con la imagen',
  exportWhole: 'Exportar un PNG que se vuelve a abrir',
};

/** Words below the icons on phones. */
export const tools: Texts['tools'] = {
  label: 'Herramientas',
  select: 'Mover',
  point: 'Punto',
  bar: 'Barra',
  polygon: 'Polígono',
  lasso: 'Lazo',
  brush: 'Pincel',
  hand: 'Mano',
  lens: 'Lupa',
  bend: 'Doblar',
};
