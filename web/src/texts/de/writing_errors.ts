import type { Texts } from '../texts';

export const writingErrors: Texts['errors']['writing'] = {
  picture: (format, why) => `Das Bild konnte nicht als ${format} geschrieben werden: ${why}`,
  film: (why) => `Der Film konnte nicht kodiert werden: ${why}`,
  filmStorage: (why) => `Der Film konnte nicht gespeichert werden: ${why}`,
  reasons: {
    encoderFailed: 'Der Kodierer ist ausgefallen oder wurde nicht geladen. Die Seite neu laden.',
    encoderStopped: 'Der Kodierer ist stehen geblieben oder wurde nicht geladen. Die Seite neu laden.',
    encoderNotLoaded: (address) =>
      `Sein Kodierer konnte nicht geladen werden: Ist ${address} da, und das Netz?`,
    canvasTooLarge:
      'Dieser Browser hat keine Zeichenfläche dieser Größe. Einen kleineren Maßstab oder PNG wählen.',
    formatUnsupported: 'Dieser Browser kann dieses Format nicht schreiben. PNG wählen.',
    noCodec: 'Dieser Browser kann dieses Format in dieser Größe nicht kodieren. Ein anderes Format wählen.',
    codecFailed:
      'Der Kodierer des Browsers ist ausgefallen. Eine kleinere Größe oder ein anderes Format wählen.',
    filmTooLarge:
      'Er braucht mehr Speicher, als dieser Browser gibt. Eine kleinere Größe oder ein anderes Format wählen.',
    zipTooLarge: 'Ein Zip fasst höchstens 4 GB. Eine kleinere Größe oder weniger Einzelbilder wählen.',
    diskFull: 'Der Datenträger ist voll.',
    diskRefuses: 'Der Datenträger nimmt es nicht an. Ist er noch da, und darf diese Seite darauf schreiben?',
    other: (detail) => `${detail}.`,
  },
};
