/**
 * The panel that explains the solution. In its sentences `r_d` and `r_h` stand for the symbols of the paper, which are
 * shown with an index.
 */
import type { Texts } from '../texts';
import { counted } from './language';

export const study: Texts['study'] = {
  title: 'Cómo funciona la deformación',
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
  title: 'Pesos en un punto',
  point: 'Apuntar a la imagen',
  nothingBends: 'Aquí no se deforma nada',
  note: 'Cada punto sigue a los puntos de control que lo rodean, según sus pesos. También puede mover la lupa con las flechas.',
  tap: 'Tocar un punto para examinarlo',
  click: 'Hacer clic para fijar este punto',
  follow: 'Seguir al puntero',
  weights: 'Pesos',
  weightsAt: (x, y) => `Los pesos en x ${x}, y ${y}`,
  noHandle: 'Esta parte no tiene punto de control, así que se queda en su sitio.',
  ownWeight: 'peso directo',
  passedOn: 'peso indirecto, a través de puntos auxiliares',
  virtualHandles: 'Puntos auxiliares',
  countOfThem: (count) => counted(count, 'punto', 'puntos'),
  virtual: (number) => `Auxiliar ${number}`,
  distancePassed: (distance, percent) => `${distance}, ${percent} indirecto`,
  spoken: (x, y, shares) => `x ${x}, y ${y}: ${shares.join(', ') || 'ningún punto de control lo mueve'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `puntos auxiliares ${percent}`,

  falloff: 'Atenuación',
  falloffOf: (handle) => `Atenuación de ${handle}`,
  noEnd: 'Es el único punto de control de su parte, así que su soporte no tiene fin.',
  falloffLabel: (value, distance, end) =>
    `La atenuación vale ${value} a una distancia de ${distance} y termina a los ${end}.`,
  radii: (cell, nearest, support) =>
    `Radio de la celda r_d ${cell}${nearest === null ? '' : `, vecino más cercano r_h ${nearest}`}${support === null ? '' : `, soporte r ${support}`}. Arrastre r en la figura o cambie α.`,
  distanceAxis: 'distancia d dentro de la forma, px',
  thisPoint: (distance) => `este punto: ${distance} →`,
};

export const cells: Texts['cells'] = {
  title: 'Celdas y sus radios',
  none: 'Añada un punto de control para ver su celda.',
  counts: (own, virtual) => `Celdas: ${own} de puntos de control, ${virtual} de puntos auxiliares`,
  label: 'La forma con sus celdas y los radios de estas',
  farthest: 'r_d, al punto más lejano de la celda',
  nearest: 'r_h, al vecino más cercano',
  note: 'Un soporte cubre su celda y termina antes del siguiente punto de control. Por eso r_h limita r_d. El artículo llama «virtual handles» a los puntos auxiliares.',
  toFarthest: 'al punto más lejano de la celda',
  toNearest: 'al vecino más cercano',
  times: 'Tiempo de cálculo por etapas',
  stages: {
    domain: 'Búsqueda del contorno',
    sampling: 'Creación de la malla',
    regions: 'Distancias, celdas y puntos auxiliares',
    weights: 'Pesos',
    pose: 'Pose',
  },
};

/** Algorithm 1 of the paper, round by round. */
export const rounds: Texts['rounds'] = {
  title: 'Algoritmo 1',
  figure: (round) => `Ronda ${round} del algoritmo 1`,
  none: 'Añada un punto de control para ejecutar el algoritmo.',
  play: 'Reproducir',
  pause: 'Pausar',
  previous: 'Ronda anterior',
  next: 'Ronda siguiente',
  round: 'Ronda',
  roundOf: (round, rounds) => `Ronda ${round} de ${rounds}`,
  end: (round, handles) =>
    `Ronda ${round}: fin. Ninguna celda es demasiado grande. Hay ${handles} puntos de control y auxiliares en total.`,
  tooLarge: (round, reach, allowed, enters) =>
    `Ronda ${round}: una celda alcanza ${reach} y supera el límite de ${allowed}. ${enters}`,
  asked: (round, enters) =>
    `Ronda ${round}: ninguna celda es demasiado grande, pero el proyecto pide más puntos auxiliares. ${enters}`,
  enters: (handle, distance, others) =>
    `Entra un punto auxiliar en la celda de ${handle}, a ${distance}${others > 0 ? `, y ${others} más en otros lugares` : ''}.`,
  curve: (score, allowed) => `La puntuación es ${score}. El límite es ${allowed}.`,
  note: 'La puntuación de la peor celda antes de cada ronda, como en la figura 3 del artículo. Bajo la línea, cada soporte cubre su celda y termina antes del siguiente punto de control. Las rondas posteriores añaden los puntos auxiliares que pide el proyecto.',
  roundAxis: 'ronda',
  allowed: 'límite',
};

export const compare: Texts['compare'] = {
  title: 'Una imagen, tres métodos',
  note: 'Arrastre los puntos de control de la imagen. Las tres siguen.',
  names: { paper: 'Artículo', rigid: 'Rígido', plain: 'Distancia simple' },
  labels: {
    paper: 'La imagen deformada como en el artículo',
    rigid: 'La imagen deformada en modo rígido',
    plain: 'La imagen deformada con la distancia simple',
  },
  notes: {
    paper: 'Distancias dentro de la forma y campos armónicos. Usted gira los puntos de control.',
    rigid: 'Las partes conservan su forma todo lo posible. Los puntos de control giran automáticamente.',
    plain:
      'Como en el artículo, pero las distancias cruzan los huecos, así que las partes cercanas también se mueven.',
  },
};

/** All settings, each with a sentence on its effect. */
export const settings: Texts['settings'] = {
  motion: 'Movimiento de los puntos auxiliares',
  motionNotes: {
    rigid:
      'Conservan la forma de la imagen: los miembros se doblan y los puntos de control giran automáticamente.',
    harmonic:
      'Los campos armónicos mezclan los movimientos de los puntos de control, como en el artículo (ec. 4). Usted gira los puntos de control.',
  },
  rigid: 'Rígido',
  byHand: 'Elástico',
  density: 'Puntos auxiliares',
  densityNote:
    'Con más puntos, la imagen se deforma con más finura y un arrastre llega menos lejos. Con 0 decide el algoritmo del artículo.',
  atLeast: 'Al menos',
  shapeFactor: 'Factor de soporte α',
  shapeFactorNote:
    'Hasta dónde llega cada punto de control. Con 0 llega poco más allá de su celda y las curvas son cerradas. Con 1 llega lo más lejos posible y las curvas son suaves.',
  support: 'Regla de soportes',
  supportNotes: {
    smooth:
      'Los soportes de los puntos auxiliares se solapan, así que la imagen se deforma de manera uniforme.',
    paper:
      'Los soportes terminan en el siguiente punto de control o auxiliar (ec. 3), así que la imagen se deforma en pasos más pequeños.',
  },
  smooth: 'Suave',
  paper: 'Artículo',
  continuity: 'Continuidad',
  continuityNotes: {
    c2: 'Las curvas también son suaves detrás de esquinas y alrededor de huecos: dos derivadas son continuas. Los huecos reciben puntos auxiliares.',
    exact:
      'Puede aparecer una arista fina detrás de un hueco, donde dos caminos a su alrededor son igual de largos.',
  },
  exact: 'Exacta',
  degree: 'Grado n de la atenuación',
  degreeNote:
    'Con 5, la curva entre dos puntos de control es corta y la imagen cercana a cada uno se mueve como una pieza. Un grado mayor reparte la curva.',
  filling: 'Forma de la atenuación',
  fillingNote:
    'El curso de la atenuación entre sus extremos, a partir del grado 7. «Línea» baja de manera uniforme. «Mitad» tiene un escalón, donde la imagen sigue por igual a dos puntos de control.',
  line: 'Línea',
  half: 'Mitad',
  blend: 'Modo de mezcla',
  blendNotes: {
    rigid: 'La mezcla de giros es un giro: una parte entre dos giros opuestos conserva su tamaño.',
    linear:
      'Los movimientos se promedian, como en el artículo (ec. 1): una parte entre dos giros opuestos se encoge.',
  },
  linear: 'Lineal',
  samples: 'Puntos de malla',
  samplesNote:
    'Las esquinas de la malla que lleva la imagen. Con más puntos, las curvas se dibujan con más finura, pero el cálculo tarda más.',
  points: 'Puntos',
  threshold: 'Opacidad mínima',
  thresholdNote:
    'Los píxeles más transparentes no se deforman. Un número menor incluye bordes suaves y pelo fino.',
  opacity: 'Opacidad',
  asInPaper: 'Valores del artículo',
  asInEditor: 'Valores del editor',
};
