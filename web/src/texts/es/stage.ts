/** The stage: its labels, hints, drawings, the brush, and the line below it. */
import type { Texts } from '../texts';
import { counted } from './language';

export const stage: Texts['stage'] = {
  keys: 'Las flechas mueven la selección. La coma y el punto la giran y, con Alt, la escalan.',
  noPicture: 'Sin imagen',
  picture: (name) => `Imagen ${name}`,
  disabled: (picture) => `${picture}, desactivada`,
  posable: (picture) => `${picture}, se posa con sus puntos de control`,
  original: 'Original',
  opening: 'Abriendo…',
  drop: 'Soltar aquí una imagen, pegarla o',
  openPicture: 'Abrir una imagen',
  required: 'Hay que abrir una imagen.',
  wouldFold: 'aquí se plegaría',
  dismiss: 'Descartar',
  handles: 'Puntos de control',
  selectionCorners: 'Esquinas de la selección',
  selectionCorner: (corner, part, x, y) =>
    `Esquina ${corner} de ${part === null ? 'la selección' : `la parte ${part} de la selección`}, x ${x}, y ${y}`,
  selectionCornerKeys: 'Las flechas la mueven. Supr la elimina y C añade otra después.',
  pictureMenu: 'Imagen',
  cornerMenu: (corner, handle) => `Esquina ${corner} de ${handle}`,
};

export const hints: Texts['hints'] = {
  bar: {
    click: 'Arrastrar una barra o hacer clic en sus esquinas',
    tap: 'Arrastrar una barra o tocar sus esquinas',
  },
  polygon: {
    click: 'Dibujar un polígono: hacer clic en sus esquinas',
    tap: 'Dibujar un polígono: tocar sus esquinas',
  },
  lasso: {
    click: 'Rodear la parte que se deforma: arrastrar o hacer clic en las esquinas',
    tap: 'Rodear la parte que se deforma: arrastrar o tocar las esquinas',
  },
  lassoAgain: 'Arrastrar una esquina de la selección o rodear otra parte',
  select: {
    click: 'Elegir la herramienta Punto y hacer clic en la imagen',
    tap: 'Elegir la herramienta Punto y tocar la imagen',
  },
  point: {
    click: 'Hacer clic en la imagen donde se quiera sujetar',
    tap: 'Tocar la imagen donde se quiera sujetar',
  },
  snapToEdges: 'Seguir bordes',
  snapToEdgesTip: 'El lazo sigue los bordes de la imagen. Mantener Alt para dibujar libremente',
};

export const drawing: Texts['drawing'] = {
  label: 'Dibujo',
  ready: 'Añadir esquinas o terminar',
  oneMore: 'Falta una esquina',
  more: (count) => `Faltan ${count} esquinas`,
  takeBack: 'Quitar la última esquina',
  giveUp: 'Abandonar el dibujo',
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
    bloat: 'Inflar: ensanchar la imagen',
    smooth: 'Suavizar: igualar los lugares que el pincel ha movido',
    restore: 'Restaurar: deshacer los trazos del pincel',
    stiffen: 'Endurecer: conservar la forma de los lugares',
  },
  hints: {
    push: 'Arrastrar para empujar la imagen.',
    pinch: 'Pulsar o arrastrar para juntar la imagen.',
    bloat: 'Pulsar o arrastrar para ensanchar la imagen.',
    smooth: 'Arrastrar para igualar los lugares que el pincel ha movido.',
    restore: 'Arrastrar para deshacer los trazos del pincel.',
    stiffen: 'Arrastrar sobre los lugares que deben conservar su forma.',
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
  clearStiffnessTip: 'Volver a ablandar la imagen',
  clearStrokes: 'Quitar los trazos del pincel',
  clearStrokesTip: 'Deshacer todo lo que el pincel ha movido',
  holding: 'Las flechas empujan, Intro suelta.',
  rigidOnly: 'La rigidez solo cuenta en la deformación rígida.',
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
  stoppedAtFold: 'Parado en un pliegue',
  creases: (count) => counted(count, 'pliegue', 'pliegues'),
  creasesAnd: (creases, effect) => `${creases}. ${effect}`,
  hideCreases: 'Ocultar los pliegues',
  showCreases: 'Mostrar los pliegues',
  zoomToCrease: 'Acercar al pliegue',
  zoomToNextCrease: 'Acercar al siguiente pliegue',
  cancel: 'Cancelar',
  samples: (count) => counted(count, 'muestra', 'muestras'),
  virtualHandles: (count) => counted(count, 'punto virtual', 'puntos virtuales'),
};

/** Work that takes noticeable time. */
export const tasks: Texts['tasks'] = {
  opening: (name) => `Abriendo ${name}`,
  start: 'Buscando el contorno',
  domain: 'Tomando muestras',
  sampling: 'Midiendo distancias',
  regions: 'Calculando pesos',
  weights: 'Calculando pesos',
  suggesting: 'Buscando lugares para puntos de control',
  filling: 'Rellenando el fondo',
  exporting: 'Exportando',
};
