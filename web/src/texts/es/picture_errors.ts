/** Errors of pictures and of the files that they are in. */
import type { Texts } from '../texts';
import { number } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: 'El archivo está vacío.',
  unreadable: 'No se ha podido leer el archivo. Es una carpeta, o se ha movido o cambiado. Elíjalo de nuevo.',
  incomplete: 'La imagen está incompleta: falta el final del archivo. Descárguelo o cópielo de nuevo.',
  unknown: 'Este navegador no puede leer el archivo como imagen. Use PNG, JPEG o WebP.',
  otherKind: (kind) => `Esto es ${kind}. Guárdelo como PNG, JPEG o WebP.`,
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
  damaged: 'La imagen está dañada o este navegador no puede leerla. Guárdela de nuevo como PNG, JPEG o WebP.',
  tooSmall: (width, height, least) =>
    `La imagen tiene ${width} × ${height} px. Debe tener al menos ${least} × ${least} px.`,
  tooLong: (width, height, most) =>
    `La imagen tiene ${width} × ${height} px. Cada lado puede tener como mucho ${number(most)} px. Reduzca la imagen.`,
  tooLarge: (width, height, millions) =>
    `La imagen tiene ${width} × ${height} px. Puede tener como mucho ${millions} millones de píxeles. Redúzcala.`,
  drawingDamaged: 'El dibujo está dañado o este navegador no puede mostrarlo.',
  drawingWithoutSize: 'El dibujo no tiene tamaño. Dele un ancho y un alto, o un viewBox.',
  drawingTooLarge: 'El dibujo ocupa más de 64 MB. Simplifíquelo.',
  drawingEncoding: (encoding) => `El dibujo no se puede leer como ${encoding}. Guárdelo como UTF-8.`,
  drawingRefused: (detail) => `El dibujo no se puede abrir: ${detail}`,
  noWebgl:
    'Este navegador no puede leer imágenes con WebGL2. Active la aceleración por hardware o use otro navegador.',
  contextLost:
    'El navegador ha perdido el acceso a la tarjeta gráfica mientras leía la imagen. Abra la imagen de nuevo.',
};

/** Errors of addresses. */
export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `No se ha podido cargar ${file}: el servidor ha respondido ${status}.`,
  webPage: (file) => `${file} es una página web. Escriba la dirección de la propia imagen.`,
  unreachable: (file) => `No se ha podido cargar ${file}. Compruebe la dirección y la conexión.`,
  refused: (file, host) =>
    `No se ha podido cargar ${file}. ${host} no permite que esta página lo lea (CORS) o no responde. Guarde la imagen y abra el archivo.`,
  damaged: 'La imagen de la dirección está dañada. Cópiela de nuevo o guárdela como archivo.',
};

/** Errors of projects in pictures. */
export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: 'El proyecto de esta imagen es demasiado grande.',
  damaged: 'El proyecto de esta imagen está dañado.',
  compressed: 'El proyecto de esta imagen está comprimido. El editor solo lee proyectos sin comprimir.',
};
