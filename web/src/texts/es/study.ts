/**
 * The card that explains the solution. In its sentences `r_d` and `r_h` stand for the symbols of the paper, which are
 * shown with an index.
 */
import type { Texts } from '../texts';
import { plural } from './language';

export const study: Texts['study'] = {
  title: 'Ver el artículo',
  page: 'Página',
  pages: {
    lens: 'Lupa',
    cells: 'Celdas',
    rounds: 'Rondas',
    compare: 'Comparar',
    settings: 'Ajustes',
  },
  close: 'Cerrar',
  saveAsSvg: 'Guardar como SVG',
};

export const lens: Texts['lens'] = {
  title: 'Los pesos de un punto',
  point: 'Apuntar a la imagen',
  nothingBends: 'Aquí no se deforma nada',
  note: 'Cada punto se mueve según los pesos de los puntos de control que lo rodean. Las flechas también mueven la lupa.',
  tap: 'Tocar un punto para verlo',
  click: 'Hacer clic para fijar este punto',
  follow: 'Seguir al puntero',
  weights: 'Pesos',
  weightsAt: (x, y) => `Los pesos en x ${x}, y ${y}`,
  noHandle: 'No hay ningún punto de control en esta parte, así que se queda quieta.',
  ownWeight: 'peso propio',
  passedOn: 'transmitido por puntos virtuales',
  virtualHandles: 'Puntos virtuales',
  countOfThem: (count) => `son ${count}`,
  virtual: (number) => `Virtual ${number}`,
  distancePassed: (distance, percent) => `${distance}, transmitido: ${percent}`,
  spoken: (x, y, shares) => `x ${x}, y ${y}: ${shares.join(', ') || 'ningún punto de control lo mueve'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `puntos virtuales ${percent}`,

  falloff: 'Atenuación',
  falloffOf: (handle) => `Atenuación de ${handle}`,
  noEnd: 'No hay otro punto de control en esta parte, así que su soporte no tiene fin.',
  falloffLabel: (value, distance, end) =>
    `La atenuación vale ${value} a la distancia de ${distance} y termina a los ${end}.`,
  radii: (cell, nearest, support) =>
    `Celda r_d ${cell}${nearest === null ? '' : `, el otro más cercano r_h ${nearest}`}${support === null ? '' : `, soporte r ${support}`}. Arrastrar r en la figura, o α.`,
  distanceAxis: 'distancia d dentro de la forma, px',
  thisPoint: (distance) => `este punto: ${distance} →`,
};

export const cells: Texts['cells'] = {
  title: 'Celdas con sus radios',
  none: 'Sin puntos de control no hay celdas.',
  counts: (own, virtual) =>
    `${own} ${plural(own, { one: 'celda', other: 'celdas' })} de puntos de control, ${virtual} de puntos virtuales`,
  label: 'La forma con sus celdas y los radios de estas',
  farthest: 'r_d, al punto más lejano de la celda',
  nearest: 'r_h, al otro punto de control más cercano',
  note: 'Un soporte cubre su celda y termina antes del siguiente punto de control no virtual. Por eso r_d debe quedar dentro del límite de r_h.',
  toFarthest: 'al punto más lejano de la celda',
  toNearest: 'al otro sitio más cercano',
  times: 'Tiempos de este cálculo',
  stages: {
    domain: 'Búsqueda del contorno',
    sampling: 'Muestreo',
    regions: 'Distancias, celdas y puntos virtuales',
    weights: 'Pesos',
    pose: 'Una pose',
  },
};

/** Algorithm 1 of the paper, round by round. */
export const rounds: Texts['rounds'] = {
  title: 'Algoritmo 1',
  figure: (round) => `Ronda ${round} del algoritmo 1`,
  none: 'Sin puntos de control no hay nada que insertar.',
  play: 'Reproducir',
  pause: 'Pausar',
  previous: 'Ronda anterior',
  next: 'Ronda siguiente',
  round: 'Ronda',
  roundOf: (round, rounds) => `Ronda ${round} de ${rounds}`,
  end: (round, handles) =>
    `Ronda ${round}: el final. Ninguna celda es demasiado grande y hay ${handles} ${plural(handles, { one: 'punto', other: 'puntos' })} de control.`,
  tooLarge: (round, reach, allowed, enters) =>
    `Ronda ${round}: una celda alcanza ${reach} y se permiten ${allowed}. ${enters}`,
  asked: (round, enters) =>
    `Ronda ${round}: ninguna celda es demasiado grande, pero el proyecto pide más puntos virtuales. ${enters}`,
  enters: (handle, distance, others) =>
    `Entra un punto virtual en la celda de ${handle}, a ${distance}${others > 0 ? `, y ${others} más en otros lugares` : ''}.`,
  curve: (score, allowed) => `La puntuación es ${score}. Puede ser como mucho ${allowed}.`,
  note: 'La puntuación de la peor celda antes de cada ronda, como en la figura 3 del artículo. Bajo la línea, cada soporte cubre su celda y termina antes del siguiente punto de control. Las rondas posteriores insertan los puntos virtuales que pide el proyecto.',
  roundAxis: 'ronda',
  allowed: 'permitido',
};

export const compare: Texts['compare'] = {
  title: 'Una imagen con tres métodos',
  note: 'Arrastrar los puntos de control de la imagen. Las tres siguen.',
  names: { paper: 'Artículo', rigid: 'Rígido', plain: 'Distancia simple' },
  labels: {
    paper: 'La imagen con el método del artículo',
    rigid: 'La imagen con el método rígido',
    plain: 'La imagen con la distancia simple',
  },
  notes: {
    paper: 'Distancias dentro de la forma y campos armónicos. Los puntos de control se giran a mano.',
    rigid: 'La forma se conserva cuanto puede. Los puntos de control giran por sí solos.',
    plain:
      'Como el artículo, pero las distancias cruzan los huecos, así que las partes cercanas también se mueven.',
  },
};

/** All settings, each with a sentence on its effect. */
export const settings: Texts['settings'] = {
  motion: 'Movimiento de los puntos virtuales',
  motionNotes: {
    rigid:
      'Conservan la forma de la imagen: los miembros se doblan y los puntos de control giran por sí solos.',
    harmonic:
      'Campos armónicos mezclan los movimientos de los puntos de control, como en el artículo (ec. 4). Los puntos de control se giran a mano.',
  },
  rigid: 'Rígido',
  byHand: 'A mano',
  density: 'Puntos virtuales',
  densityNote:
    'Con más puntos, la imagen se deforma con más finura y un arrastre llega menos lejos. Con 0 decide el algoritmo del artículo.',
  atLeast: 'Al menos',
  shapeFactor: 'Factor de soporte α',
  shapeFactorNote:
    'Hasta dónde llega cada punto de control. Con 0 llega poco más allá de su celda y las curvas son cerradas. Con 1 llega tan lejos como puede y las curvas son suaves.',
  support: 'Regla de los soportes',
  supportNotes: {
    smooth: 'Los soportes de los puntos virtuales se solapan. La imagen se deforma de manera uniforme.',
    paper:
      'Los soportes terminan en el siguiente punto de control, también en los virtuales (ec. 3). La imagen se deforma en pasos más pequeños.',
  },
  smooth: 'Suave',
  paper: 'Artículo',
  continuity: 'Continuidad',
  continuityNotes: {
    c2: 'Las curvas también son suaves detrás de esquinas y alrededor de huecos: dos derivadas continuas. Los huecos reciben puntos virtuales.',
    exact:
      'La imagen puede mostrar un pliegue fino detrás de un hueco, donde dos caminos a su alrededor son igual de largos.',
  },
  exact: 'Exacta',
  degree: 'Grado n de la atenuación',
  degreeNote:
    'Con 5, la curva entre dos puntos de control es corta y las partes cercanas a ellos se mueven como una sola. Un grado mayor la reparte por el camino.',
  filling: 'Relleno de la atenuación',
  fillingNote:
    'Cómo sigue la atenuación entre sus extremos, a partir del grado 7. «Línea» baja de manera uniforme. «Mitad» mantiene un escalón, donde las partes siguen a medias a dos puntos de control.',
  line: 'Línea',
  half: 'Mitad',
  blend: 'Modo de mezcla',
  blendNotes: {
    rigid: 'De giros se obtienen giros: una parte entre dos giros opuestos conserva su tamaño.',
    linear:
      'Los movimientos se promedian, como en el artículo (ec. 1): una parte entre dos giros opuestos se encoge.',
  },
  linear: 'Lineal',
  samples: 'Muestras',
  samplesNote:
    'Los puntos que llevan la imagen. Con más muestras las curvas se dibujan con más finura y el cálculo tarda más.',
  points: 'Puntos',
  threshold: 'Opacidad mínima',
  thresholdNote:
    'Lo que es más transparente que esto no se deforma. Un número menor incluye bordes suaves y pelo fino.',
  opacity: 'Opacidad',
  asInPaper: 'Como en el artículo',
  asInEditor: 'Como en el editor',
};
