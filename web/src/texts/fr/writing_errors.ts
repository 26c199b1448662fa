/** Errors of files that are written: exports of pictures and films. */
import type { Texts } from '../texts';

export const writingErrors: Texts['errors']['writing'] = {
  picture: (format, why) => `Impossible d’écrire le fichier ${format} : ${why}`,
  film: (why) => `Impossible d’encoder le film : ${why}`,
  filmStorage: (why) => `Impossible d’enregistrer le film : ${why}`,
  reasons: {
    encoderFailed: 'l’encodeur a échoué ou ne s’est pas chargé. Rechargez la page.',
    encoderStopped: 'l’encodeur s’est arrêté ou ne s’est pas chargé. Rechargez la page.',
    encoderNotLoaded: (address) =>
      `l’encodeur ne s’est pas chargé. Vérifiez que ${address} existe, et vérifiez la connexion.`,
    canvasTooLarge:
      'ce navigateur ne peut pas dessiner une image de cette taille. Choisissez une taille plus petite, ou PNG.',
    formatUnsupported: 'ce navigateur ne sait pas écrire ce format. Choisissez PNG.',
    noCodec: 'ce navigateur ne peut pas encoder ce format à cette taille. Choisissez un autre format.',
    codecFailed: 'l’encodeur du navigateur a échoué. Choisissez une taille plus petite, ou un autre format.',
    filmTooLarge:
      'il est trop volumineux pour la mémoire de ce navigateur. Choisissez une taille plus petite, ou un autre format.',
    zipTooLarge: 'un zip contient au plus 4 Go. Choisissez une taille plus petite, ou moins d’images.',
    diskFull: 'le disque est plein.',
    diskRefuses: 'le disque le refuse. Vérifiez qu’il est connecté et que cette page peut y écrire.',
    other: (detail) => `${detail}.`,
  },
};
