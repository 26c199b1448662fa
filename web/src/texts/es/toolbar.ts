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
  noFile: 'últimos cambios no guardados en un archivo',
  kept: 'conservado en este navegador',
};

export const files: Texts['files'] = {
  label: 'Abrir un trabajo reciente, un ejemplo o una dirección',
  address: 'Dirección de una imagen o un proyecto',
  placeholder: 'https://…/imagen.png',
  open: 'Abrir',
  recent: 'Trabajos recientes',
  removeAll: 'Quitar todo',
  noRecent: 'Las imágenes editadas aparecen aquí al abrir otra.',
  remove: (name) => `Quitar ${name} de la lista`,
  drawing: 'dibujo sin terminar',
  steps: (count) => counted(count, 'paso', 'pasos'),
  samples: 'Ejemplos',
  openSample: (name) => `Abrir el ejemplo ${name}`,
  whole: 'Todo en un archivo',
  saveWhole: 'Guardar con la imagen',
  exportWhole: 'Exportar un PNG editable',
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
