/** Errors of the solver and its worker. */
import type { Texts } from '../texts';
import { quoted } from './language';

/** Why something is too much for the solver, mostly for lack of memory. */
export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: 'La imagen es demasiado grande para la memoria. Redúzcala.',
  pictures: 'Las imágenes son demasiado grandes para la memoria. Redúzcalas.',
  suggest: 'No hay memoria suficiente para sugerir puntos de control. Reduzca la imagen.',
  solve: 'No hay memoria suficiente para esta deformación. Use menos puntos de control o menos detalle.',
  fill: 'No hay memoria suficiente para rellenar el fondo. Reduzca la imagen.',
  draw: 'No hay memoria suficiente para dibujar la imagen. Elija un tamaño menor.',
  film: 'No hay memoria suficiente en este navegador para dibujar el vídeo. Elija un tamaño menor.',
  points: 'No hay memoria suficiente para tantos puntos.',
  cells: 'No hay memoria suficiente en este navegador para calcular las celdas.',
  study: 'No hay memoria suficiente en este navegador para calcular las figuras.',
  lens: 'No hay memoria suficiente en este navegador para la lupa.',
  rig: 'Los clips son demasiado largos para un rig en este navegador. Acórtelos.',
  map: 'El archivo es demasiado grande para este navegador. Use la línea de comandos.',
  drawing: 'El dibujo es demasiado complejo para este navegador. Simplifíquelo.',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `No se ha podido cargar el motor de cálculo: ${why}`,
  exportNotLoaded: (why) => `No se ha podido iniciar la exportación: ${why}`,
  status: (address, status) => `el servidor ha respondido ${status} para ${address}.`,
  isPage: (address) => `el servidor ha enviado una página web en lugar de ${address}.`,
  absent: (address) =>
    `no se puede acceder a ${address}. Compruebe la conexión y la política de seguridad de la página.`,
  incomplete: (address, detail) => `${address} está incompleto o no puede ejecutarse aquí (${detail}).`,
  noWorkers: 'No se ha podido iniciar el motor de cálculo: este navegador o esta página no permite workers.',
  notStarted: (address) =>
    `No se ha podido iniciar el motor de cálculo. Compruebe que ${address} existe y que la página permite workers.`,
  exportNotStarted: (address) =>
    `No se ha podido iniciar la exportación. Compruebe que ${address} existe y que la página permite workers.`,
  drawingNotChecked:
    'Este dibujo necesita una parte del editor que no se ha podido cargar. Compruebe la conexión y que la página permita workers.',
  lostDrawing: 'El motor de cálculo ha fallado al dibujar.',
  released: 'Los píxeles de la imagen ya no están en la memoria. Abra la imagen de nuevo.',
};

/** Refusals of the solver, by their codes. */
export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `El proyecto no es válido: ${detail}`,
  picture: (detail) => `La imagen no se puede usar: ${detail}`,
  'picture-mismatch': () => 'El proyecto es para una imagen de otro tamaño.',
  scale: () => 'La exportación sería demasiado grande o demasiado pequeña. Elija otro tamaño.',
  canvas: () => 'La imagen ampliada sería demasiado grande. Elija un tamaño menor o el marco original.',
  'nothing-drawn': () => 'La imagen es transparente en todas partes.',
  'nothing-opaque': () =>
    'Ninguna parte de la imagen es lo bastante opaca para deformarla. Baje el ajuste «Opacidad mínima».',
  'nothing-to-fill-from': () =>
    'La selección no deja nada con que rellenar el fondo. Dibuje una más pequeña o desactive el relleno.',
  'no-outline': () =>
    'La imagen no tiene partes transparentes y, por tanto, ningún contorno al que ajustar un rig.',
  domain: (detail) => `La selección no es válida: ${detail}`,
  'handle-outside': (_, name) => `${quoted(name)} queda fuera de la forma. Colóquelo sobre la imagen.`,
  'handle-far-outside': (_, name) => `Este rig no encaja en la imagen: ${quoted(name)} quedaría muy lejos.`,
  'handles-too-close': (_, name, other) =>
    `${quoted(name)} y ${quoted(other)} están en el mismo lugar. Mueva o elimine uno.`,
  'bar-too-short': (_, name) =>
    `Dos esquinas de ${quoted(name)} están en el mismo lugar. Mueva o elimine una.`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `${quoted(name)} vuelve sobre sí mismo. Sus tramos pueden cruzarse o tocarse, pero no superponerse.`
      : `${quoted(name)} y ${quoted(other)} coinciden en un tramo. Pueden cruzarse o tocarse, pero no superponerse.`,
  'on-held-boundary': (_, name) =>
    `${quoted(name)} está en el contorno fijado. Muévalo hacia dentro o libere el contorno.`,
  'too-many-handles': () => 'Hay demasiados puntos de control. Elimine algunos.',
  'too-many-corners': (_, name) =>
    `Las barras y los polígonos tienen demasiadas esquinas. Dibuje ${quoted(name)} con menos.`,
  'handles-crowded': () => 'Demasiados puntos de control están muy juntos. Separe o elimine algunos.',
  'outline-too-long': () =>
    'Este contorno tiene demasiadas ranuras y puntas. Dibuje uno más simple o más amplio.',
  'too-many-sites': () =>
    'Los puntos de control son demasiados o están demasiado juntos. Separe algunos o use menos detalle.',
  'too-much-memory': () =>
    'Esta deformación necesita demasiada memoria para un navegador. Use menos puntos de control o menos detalle.',
  'too-much-work': () =>
    'Esta deformación es demasiado compleja para calcularla en unos segundos. Use menos puntos de control o un contorno más simple.',
  'held-too-fine': () =>
    'Este contorno tiene demasiadas esquinas para fijarlo. Dibuje uno más simple o libere el contorno.',
  unsupported: (detail) => `No se admite un ajuste del proyecto: ${detail}`,
  pose: (detail) => `La pose no es válida: ${detail}`,
  film: (detail) => `El vídeo no es posible: ${detail}`,
  'point-outside': (detail) => `El punto no sirve: ${detail}`,
  mesh: (detail) => `La malla no es válida: ${detail}`,
  cloud: (detail) => `La nube de puntos no es válida: ${detail}`,
  poser: (detail) => `No se puede calcular la pose: ${detail}`,
};
