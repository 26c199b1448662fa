/** The stage: its labels, hints, drawings, the brush, and the line below it. */
import type { Texts } from '../texts';
import { counted } from './language';

export const stage: Texts['stage'] = {
  keys: 'Las flechas mueven la selección. La coma y el punto la giran y, con Alt, la escalan.',
  noPicture: 'Sin imagen',
  picture: (name) => `Imagen ${name}`,
  disabled: (picture) => `${picture}, desactivada`,
  posable: (picture) => `${picture}, con puntos de control para moverla`,
  original: 'Original',
  opening: 'Abriendo…',
  drop: 'Soltar aquí una imagen, pegarla o',
  openPicture: 'Abrir una imagen',
  required: 'Abra una imagen.',
  wouldFold: 'aquí se plegaría',
  dismiss: 'Descartar',
  handles: 'Puntos de control',
  selectionCorners: 'Esquinas de la selección',
  selectionCorner: (corner, part, x, y) =>
    `Esquina ${corner} de ${part === null ? 'la selección' : `la parte ${part} de la selección`}, x ${x}, y ${y}`,
  selectionCornerKeys: 'Las flechas mueven la esquina. Supr la elimina y C añade otra después.',
  pictureMenu: 'Imagen',
  cornerMenu: (corner, handle) => `Esquina ${corner} de ${handle}`,
};

export const hints: Texts['hints'] = {
  bar: {
    click: 'Arrastrar para dibujar una barra o hacer clic en sus esquinas',
    tap: 'Arrastrar para dibujar una barra o tocar sus esquinas',
  },
  polygon: {
    click: 'Hacer clic en las esquinas del polígono',
    tap: 'Tocar las esquinas del polígono',
  },
  lasso: {
    click: 'Rodear la parte que se quiere deformar: arrastrar o hacer clic en las esquinas',
    tap: 'Rodear la parte que se quiere deformar: arrastrar o tocar las esquinas',
  },
  lassoAgain: 'Arrastrar una esquina de la selección o rodear otra parte',
  select: {
    click: 'Elegir la herramienta Punto y hacer clic en la imagen',
    tap: 'Elegir la herramienta Punto y tocar la imagen',
  },
  point: {
    click: 'Hacer clic en la imagen donde se quiera un punto de control',
    tap: 'Tocar la imagen donde se quiera un punto de control',
  },
  snapToEdges: 'Seguir bordes',
  snapToEdgesTip: 'El lazo sigue los bordes de la imagen. Mantenga Alt para dibujar libremente',
};

export const drawing: Texts['drawing'] = {
  label: 'Dibujo',
  ready: 'Añadir esquinas o terminar',
  oneMore: 'Falta una esquina',
  more: (count) => `Faltan ${count} esquinas`,
  takeBack: 'Quitar la última esquina',
  giveUp: 'Cancelar el dibujo',
  finish: 'Terminar',
};

export const brush: Texts['brush'] = {
  label: 'Pincel',
  effect: 'Efecto del pincel',
  kinds: {
    push: 'Empujar',
    pinch: 'Contraer',
    bloat: 'Inflar',
    smooth: 'Suavizar',
    restore: 'Restaurar',
    stiffen: 'Endurecer',
  },
  tips: {
    push: 'Empujar: arrastrar la imagen',
    pinch: 'Contraer: juntar la imagen',
    bloat: 'Inflar: empujar la imagen hacia fuera',
    smooth: 'Suavizar: igualar los trazos del pincel',
    restore: 'Restaurar: quitar los trazos del pincel',
    stiffen: 'Endurecer: mantener zonas rígidas',
  },
  hints: {
    push: 'Arrastrar para empujar la imagen.',
    pinch: 'Pulsar o arrastrar para juntar la imagen.',
    bloat: 'Pulsar o arrastrar para empujar la imagen hacia fuera.',
    smooth: 'Arrastrar para igualar los trazos del pincel.',
    restore: 'Arrastrar para quitar los trazos del pincel.',
    stiffen: 'Arrastrar sobre las zonas que deben quedar rígidas.',
  },
  altHints: {
    push: 'Alt restaura.',
    pinch: 'Alt infla.',
    bloat: 'Alt contrae.',
    smooth: '',
    restore: 'Alt empuja.',
    stiffen: 'Alt borra.',
  },
  size: 'Tamaño',
  strength: 'Fuerza',
  sizeLabel: 'Tamaño del pincel (%)',
  strengthLabel: 'Fuerza del pincel (%)',
  erase: 'Borrar',
  eraseTip: 'Borrar la rigidez',
  clearStiffness: 'Quitar la rigidez',
  clearStiffnessTip: 'Volver a ablandar toda la imagen',
  clearStrokes: 'Quitar los trazos del pincel',
  clearStrokesTip: 'Quitar todos los trazos del pincel de la imagen',
  holding: 'Las flechas empujan, Intro suelta.',
  rigidOnly: 'La rigidez solo funciona en el modo rígido.',
  bendRigidly: 'Usar el modo rígido',
};

/** The line at the bottom. */
export const status: Texts['status'] = {
  label: 'Estado',
  hasCreases: 'La imagen tiene pliegues',
  privacy: 'Nada sale del navegador',
  privacyTip: 'Las imágenes se abren, se deforman y se guardan solo en este equipo.',
  view: 'Vista',
  zoom: 'Zoom',
  seeIt: 'Ver',
  out: 'Alejar',
  in: 'Acercar',
  fit: 'Ajustar',
  actual: 'Real',
  stoppedAtFold: 'Detenido en un pliegue',
  creases: (count) => counted(count, 'pliegue', 'pliegues'),
  creasesAnd: (creases, effect) => `${creases}. ${effect}`,
  hideCreases: 'Ocultar los pliegues',
  showCreases: 'Mostrar los pliegues',
  zoomToCrease: 'Acercar al pliegue',
  zoomToNextCrease: 'Acercar al siguiente pliegue',
  cancel: 'Cancelar',
  samples: (count) => counted(count, 'punto de malla', 'puntos de malla'),
  virtualHandles: (count) => counted(count, 'punto auxiliar', 'puntos auxiliares'),
};

/** Work that takes noticeable time. */
export const tasks: Texts['tasks'] = {
  opening: (name) => `Abriendo ${name}`,
  start: 'Buscando el contorno',
  domain: 'Creando la malla',
  sampling: 'Midiendo distancias',
  regions: 'Calculando pesos',
  weights: 'Calculando pesos',
  suggesting: 'Buscando lugares para puntos de control',
  filling: 'Rellenando el fondo',
  exporting: 'Exportando',
};
