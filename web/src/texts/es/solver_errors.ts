/** Errors of the solver and its worker. */
import type { Texts } from '../texts';
import { quoted } from './language';

/** Why something is more than the solver can do, mostly for want of memory. */
export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: 'La imagen necesita más memoria de la que hay: hay que reducirla.',
  pictures: 'Las imágenes necesitan más memoria de la que hay: hay que reducirlas.',
  suggest: 'Para sugerir puntos de control, la imagen necesita más memoria de la que hay: hay que reducirla.',
  solve: 'Esto es más de lo que se puede calcular con la memoria que hay.',
  fill: 'Para rellenar el fondo, la imagen necesita más memoria de la que hay: hay que reducirla.',
  draw: 'Para dibujarse, la imagen necesita más memoria de la que hay.',
  film: 'Para dibujarse, el vídeo necesita más memoria de la que da este navegador.',
  points: 'Los puntos necesitan más memoria de la que hay.',
  cells: 'Las celdas son más de lo que se puede calcular en este navegador.',
  study: 'Las figuras son más de lo que se puede calcular en este navegador.',
  lens: 'La lupa es más de lo que se puede calcular en este navegador.',
  rig: 'Los clips son más de lo que cabe en un rig en este navegador: hay que acortarlos.',
  map: 'El archivo es más de lo que cabe en este navegador: la línea de comandos lo escribe.',
  drawing: 'El dibujo es más de lo que este navegador puede deformar: hay que simplificarlo.',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `No se ha podido cargar el motor de cálculo: ${why}`,
  exportNotLoaded: (why) => `No se ha podido iniciar la exportación: ${why}`,
  status: (address, status) => `${address} responde ${status}`,
  isPage: (address) => `${address} no está: en su lugar hay una página`,
  absent: (address) => `${address} no llega: ¿hay red y lo permite la página?`,
  incomplete: (address, detail) => `${address} ha llegado incompleto o no puede ejecutarse aquí (${detail}).`,
  noWorkers: 'No se ha podido iniciar el motor de cálculo: este navegador o esta página no permite workers.',
  notStarted: (address) =>
    `El motor de cálculo ha fallado: no se ha podido iniciar su worker. ¿Está ${address} y lo permite la página?`,
  exportNotStarted: (address) =>
    `No se ha podido iniciar la exportación: ¿está ${address} y permite workers la página?`,
  lostDrawing: 'El motor de cálculo ha fallado durante el dibujo.',
  released:
    'Los píxeles de la imagen ya no están o no hay memoria para ellos. Hay que abrir la imagen de nuevo.',
};

/** Refusals of the solver, by their codes. */
export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `El proyecto no es válido: ${detail}`,
  picture: (detail) => `La imagen no se puede usar: ${detail}`,
  'picture-mismatch': () => 'El proyecto es para una imagen de otro tamaño.',
  scale: () => 'La exportación sería demasiado grande o demasiado pequeña: hay que elegir otro tamaño.',
  canvas: () =>
    'La imagen entera sería demasiado grande: hay que elegir un tamaño menor o el rectángulo del original.',
  'nothing-drawn': () => 'No hay nada cubierto: la imagen es transparente en todas partes.',
  'nothing-opaque': () =>
    'Nada en esta imagen es lo bastante opaco para deformarse. El ajuste «Opacidad mínima» se puede bajar.',
  'nothing-to-fill-from': () =>
    'No queda nada alrededor de la selección con que rellenar su fondo: hay que dibujar una más pequeña o dejarlo vacío.',
  'no-outline': () =>
    'La imagen no tiene partes transparentes y, por tanto, ningún contorno al que ajustar un rig.',
  domain: (detail) => `La selección no es válida: ${detail}`,
  'handle-outside': (_, name) =>
    `${quoted(name)} queda fuera de la forma: hay que colocarlo sobre la imagen.`,
  'handle-far-outside': (_, name) =>
    `${quoted(name)} quedaría muy lejos de esta imagen: el rig no encaja en ella.`,
  'handles-too-close': (_, name, other) =>
    `${quoted(name)} y ${quoted(other)} están en el mismo lugar: hay que mover o eliminar uno.`,
  'bar-too-short': (_, name) =>
    `Dos esquinas de ${quoted(name)} están en el mismo lugar: hay que mover o eliminar una.`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `${quoted(name)} vuelve sobre sí: sus tramos pueden cruzarse y tocarse, pero no superponerse.`
      : `${quoted(name)} y ${quoted(other)} coinciden en un tramo: pueden cruzarse y tocarse, pero no superponerse.`,
  'on-held-boundary': (_, name) =>
    `${quoted(name)} está en el contorno, que está sujeto: hay que moverlo hacia dentro o soltar el contorno.`,
  'too-many-handles': () => 'Hay demasiados puntos de control: hay que eliminar algunos.',
  'too-many-corners': (_, name) =>
    `Las barras y los polígonos tienen demasiadas esquinas: hay que dibujar ${quoted(name)} con menos.`,
  'handles-crowded': () =>
    'Demasiados puntos de control están muy juntos: hay que separar algunos o eliminarlos.',
  'outline-too-long': () =>
    'Este contorno tiene demasiadas ranuras y puntas: hay que dibujar uno más simple o más amplio.',
  'too-many-sites': () =>
    'Los puntos de control están demasiado juntos o son demasiados: hay que separar algunos o usar menos detalle.',
  'too-much-memory': () =>
    'Esto necesita más memoria de la que tiene un navegador: hay que usar menos puntos de control o menos detalle.',
  'too-much-work': () =>
    'Esto es demasiado intrincado para resolverlo en unos segundos: hay que usar menos puntos de control o un contorno más sencillo.',
  'held-too-fine': () =>
    'Este contorno tiene demasiadas esquinas para sujetarlo: hay que dibujar uno más simple o dejar que se mueva.',
  unsupported: (detail) => `No se admite un ajuste del proyecto: ${detail}`,
  pose: (detail) => `La pose no es válida: ${detail}`,
  film: (detail) => `El vídeo no es posible: ${detail}`,
  'point-outside': (detail) => `El punto no sirve: ${detail}`,
  mesh: (detail) => `La malla no es válida: ${detail}`,
  cloud: (detail) => `La nube de puntos no es válida: ${detail}`,
  poser: (detail) => `No se puede calcular la pose: ${detail}`,
};
