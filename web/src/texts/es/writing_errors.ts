/** Errors of files that are written: exports of pictures and films. */
import type { Texts } from '../texts';

export const writingErrors: Texts['errors']['writing'] = {
  picture: (format, why) => `No se ha podido escribir el ${format}: ${why}`,
  film: (why) => `No se ha podido codificar el vídeo: ${why}`,
  filmStorage: (why) => `No se ha podido guardar el vídeo: ${why}`,
  reasons: {
    encoderFailed: 'el codificador ha fallado o no se ha cargado. Recargue la página.',
    encoderStopped: 'el codificador se ha detenido o no se ha cargado. Recargue la página.',
    encoderNotLoaded: (address) =>
      `el codificador no se ha cargado. Compruebe que ${address} existe y compruebe la conexión.`,
    canvasTooLarge: 'este navegador no puede dibujar una imagen de este tamaño. Elija un tamaño menor o PNG.',
    formatUnsupported: 'este navegador no puede escribir este formato. Elija PNG.',
    noCodec: 'este navegador no puede codificar este formato a este tamaño. Elija otro formato.',
    codecFailed: 'el codificador del navegador ha fallado. Elija un tamaño menor u otro formato.',
    filmTooLarge:
      'es demasiado grande para la memoria de este navegador. Elija un tamaño menor u otro formato.',
    zipTooLarge: 'en un zip caben como mucho 4 GB. Elija un tamaño menor o menos fotogramas.',
    diskFull: 'el disco está lleno.',
    diskRefuses:
      'el disco no lo acepta. Compruebe que está conectado y que esta página puede escribir en él.',
    other: (detail) => `${detail}.`,
  },
};
