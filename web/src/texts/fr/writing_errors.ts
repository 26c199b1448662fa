/** Errors of files that are written: exports of pictures and films. */
import type { Texts } from '../texts';

export const writingErrors: Texts['errors']['writing'] = {
  picture: (format, why) => `L’écriture du fichier ${format} a échoué : ${why}`,
  film: (why) => `Le film n’a pas pu être encodé : ${why}`,
  filmStorage: (why) => `Le film n’a pas pu être enregistré : ${why}`,
  reasons: {
    encoderFailed: 'l’encodeur a échoué ou ne s’est pas chargé. Rechargez la page.',
    encoderStopped: 'l’encodeur s’est arrêté ou ne s’est pas chargé. Rechargez la page.',
    encoderNotLoaded: (address) =>
      `son encodeur n’a pas pu être chargé : ${address} est-il là, et le réseau aussi ?`,
    canvasTooLarge:
      'ce navigateur n’a pas de canevas de cette taille. Choisissez une échelle plus petite, ou PNG.',
    formatUnsupported: 'ce navigateur ne sait pas écrire ce format. Choisissez PNG.',
    noCodec: 'ce navigateur n’encode pas ce format à cette taille. Choisissez un autre format.',
    codecFailed: 'l’encodeur du navigateur a échoué. Choisissez une taille plus petite, ou un autre format.',
    filmTooLarge:
      'il faut plus de mémoire que ce navigateur n’en donne. Choisissez une taille plus petite, ou un autre format.',
    zipTooLarge: 'un zip contient au plus 4 Go. Choisissez une taille plus petite, ou moins d’images.',
    diskFull: 'le disque est plein.',
    diskRefuses: 'le disque ne l’accepte pas. Est-il toujours là, et cette page peut-elle y écrire ?',
    other: (detail) => `${detail}.`,
  },
};
