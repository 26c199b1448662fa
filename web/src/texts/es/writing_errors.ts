/** Errors of files that are written: exports of pictures and films. */
import type { Texts } from '../texts';

export const writingErrors: Texts['errors']['writing'] = {
  picture: (format, why) => `No se ha podido escribir el ${format}: ${why}`,
  film: (why) => `No se ha podido codificar el vídeo: ${why}`,
  filmStorage: (why) => `No se ha podido guardar el vídeo: ${why}`,
  reasons: {
    encoderFailed: 'el codificador ha fallado o no se ha cargado. Hay que recargar la página.',
    encoderStopped: 'el codificador se ha detenido o no se ha cargado. Hay que recargar la página.',
    encoderNotLoaded: (address) => `no se ha podido cargar su codificador: ¿está ${address} y hay red?`,
    canvasTooLarge: 'este navegador no tiene lienzos de este tamaño. Hay que elegir una escala menor o PNG.',
    formatUnsupported: 'este navegador no puede escribir este formato. Se puede elegir PNG.',
    noCodec: 'este navegador no codifica este formato a este tamaño. Hay que elegir otro formato.',
    codecFailed: 'el codificador del navegador ha fallado. Hay que elegir un tamaño menor u otro formato.',
    filmTooLarge:
      'necesita más memoria de la que da este navegador. Hay que elegir un tamaño menor u otro formato.',
    zipTooLarge: 'en un zip caben como mucho 4 GB. Hay que elegir un tamaño menor o menos fotogramas.',
    diskFull: 'el disco está lleno.',
    diskRefuses: 'el disco no lo acepta. ¿Sigue ahí, y puede esta página escribir en él?',
    other: (detail) => `${detail}.`,
  },
};
