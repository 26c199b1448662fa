/** Errors of pictures and of the files that they are in. */
import type { Texts } from '../texts';
import { number } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: 'El archivo está vacío.',
  unreadable:
    'No se puede leer el archivo: es una carpeta, o se ha movido o cambiado. Hay que elegirlo de nuevo.',
  incomplete: 'La imagen está incompleta: falta el final del archivo. Hay que obtenerlo de nuevo.',
  unknown: 'El archivo no es una imagen que este navegador pueda leer. Se puede usar PNG, JPEG o WebP.',
  otherKind: (kind) => `Esto es ${kind}. Hay que guardarlo como PNG, JPEG o WebP.`,
  kinds: {
    png: 'una imagen PNG',
    jpeg: 'una imagen JPEG',
    gif: 'una imagen GIF',
    webp: 'una imagen WebP',
    avif: 'una imagen AVIF',
    heic: 'una imagen HEIC',
    bmp: 'una imagen BMP',
    icon: 'un icono',
    tiff: 'una imagen TIFF',
    photoshop: 'un documento de Photoshop',
    pdf: 'un documento PDF',
    postscript: 'un documento PostScript',
    jpegXl: 'una imagen JPEG XL',
    jpeg2000: 'una imagen JPEG 2000',
    svg: 'un dibujo SVG',
    compressed: 'un archivo comprimido',
  },
  damaged:
    'La imagen está dañada o este navegador no puede leerla. Hay que guardarla de nuevo como PNG, JPEG o WebP.',
  tooSmall: (width, height, least) =>
    `La imagen tiene ${width} × ${height} px. Debe tener al menos ${least} × ${least} px.`,
  tooLong: (width, height, most) =>
    `La imagen tiene ${width} × ${height} px. Un lado puede tener como mucho ${number(most)} px: hay que reducir la imagen.`,
  tooLarge: (width, height, millions) =>
    `La imagen tiene ${width} × ${height} px. Puede tener como mucho ${millions} millones de píxeles: hay que reducir la imagen.`,
  drawingDamaged: 'El dibujo está dañado o este navegador no puede mostrarlo.',
  drawingWithoutSize: 'El dibujo no tiene tamaño. Necesita un ancho y un alto, o un viewBox.',
  drawingTooLarge: 'El dibujo ocupa más de 64 MB. Hay que simplificarlo.',
  drawingEncoding: (encoding) => `El dibujo no se puede leer como ${encoding}. Hay que guardarlo como UTF-8.`,
  drawingUnread: 'No se pudo leer el dibujo. Hay que comprobar la conexión y volver a abrirlo.',
  drawingTooManyElements: (most) =>
    `El dibujo tiene más de ${number(most)} elementos. Hay que simplificarlo.`,
  drawingTooManyAttributes: (most) =>
    `Un elemento del dibujo tiene más de ${most} atributos. Hay que quitar algunos.`,
  drawingTooDeep: (most) =>
    `Hay elementos del dibujo anidados a más de ${most} niveles. Hay que desagrupar algunos.`,
  drawingTooManyCopies:
    'Algunos elementos del dibujo se reutilizan demasiado. Hay que usar otros más pequeños o reutilizarlos menos.',
  drawingTooManyStyles: 'Los estilos del dibujo tardan demasiado. Hay que simplificarlos.',
  drawingTooSlow: (element) =>
    `El dibujo tarda demasiado en dibujarse, sobre todo sus <${element}>. Hay que simplificarlo.`,
  drawingTooMuchMemory: (element) =>
    `El dibujo necesita demasiada memoria para dibujarse, sobre todo sus <${element}>. Hay que simplificarlo.`,
  noWebgl:
    'Este navegador no puede leer imágenes con WebGL2. Hay que activar la aceleración por hardware o usar otro navegador.',
  contextLost: 'Se ha perdido el contexto gráfico mientras se leía la imagen. Hay que abrirla de nuevo.',
};

/** Errors of addresses. */
export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `No se ha podido cargar ${file}: el servidor ha respondido ${status}.`,
  webPage: (file) =>
    `No se ha podido cargar ${file}: es una página web. Hay que indicar la dirección de la propia imagen.`,
  unreachable: (file) =>
    `No se ha podido cargar ${file}. Conviene comprobar la dirección y la conexión de red.`,
  refused: (file, host) =>
    `No se ha podido cargar ${file}. ${host} no permite que esta página lo lea (CORS) o no responde. Se puede guardar la imagen y abrir el archivo.`,
  damaged: 'La imagen de la dirección está dañada. Hay que copiarla de nuevo o guardarla como archivo.',
};

/** Errors of projects in pictures. */
export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: 'El proyecto en esta imagen es demasiado largo.',
  damaged: 'El proyecto en esta imagen está dañado.',
  compressed: 'El proyecto en esta imagen está comprimido, y eso no se admite.',
};
