import type { Texts } from '../texts';

export const writingErrors: Texts['errors']['writing'] = {
  picture: (format, why) => `Das Bild konnte nicht als ${format} geschrieben werden: ${why}`,
  film: (why) => `Der Film konnte nicht kodiert werden: ${why}`,
  filmStorage: (why) => `Der Film konnte nicht gespeichert werden: ${why}`,
  reasons: {
    encoderFailed: 'Der Kodierer ist ausgefallen oder wurde nicht geladen. Laden Sie die Seite neu.',
    encoderStopped: 'Der Kodierer ist stehen geblieben oder wurde nicht geladen. Laden Sie die Seite neu.',
    encoderNotLoaded: (address) =>
      `Der Kodierer wurde nicht geladen. Prüfen Sie, ob ${address} existiert, und prüfen Sie die Verbindung.`,
    canvasTooLarge:
      'Dieser Browser kann kein Bild dieser Größe zeichnen. Wählen Sie eine kleinere Größe oder PNG.',
    formatUnsupported: 'Dieser Browser kann dieses Format nicht schreiben. Wählen Sie PNG.',
    noCodec:
      'Dieser Browser kann dieses Format in dieser Größe nicht kodieren. Wählen Sie ein anderes Format.',
    codecFailed:
      'Der Kodierer des Browsers ist ausgefallen. Wählen Sie eine kleinere Größe oder ein anderes Format.',
    filmTooLarge:
      'Er ist zu groß für den Speicher dieses Browsers. Wählen Sie eine kleinere Größe oder ein anderes Format.',
    zipTooLarge: 'Ein Zip fasst höchstens 4 GB. Wählen Sie eine kleinere Größe oder weniger Einzelbilder.',
    diskFull: 'Der Datenträger ist voll.',
    diskRefuses:
      'Der Datenträger nimmt die Datei nicht an. Prüfen Sie, ob er verbunden ist und diese Seite darauf schreiben darf.',
    other: (detail) => `${detail}.`,
  },
};
