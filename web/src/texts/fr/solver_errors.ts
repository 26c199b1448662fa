/** Errors of the solver and its worker. */
import type { Texts } from '../texts';
import { quoted } from './language';

/** Why something is too much for the solver, mostly for lack of memory. */
export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: 'L’image est trop grande pour la mémoire. Réduisez-la.',
  pictures: 'Les images sont trop grandes pour la mémoire. Réduisez-les.',
  suggest: 'Mémoire insuffisante pour suggérer des poignées. Réduisez l’image.',
  solve: 'Mémoire insuffisante pour cette déformation. Utilisez moins de poignées, ou moins de détail.',
  fill: 'Mémoire insuffisante pour remplir le fond. Réduisez l’image.',
  draw: 'Mémoire insuffisante pour dessiner l’image. Choisissez une taille plus petite.',
  film: 'Mémoire insuffisante dans ce navigateur pour dessiner le film. Choisissez une taille plus petite.',
  points: 'Mémoire insuffisante pour autant de points.',
  cells: 'Mémoire insuffisante dans ce navigateur pour calculer les cellules.',
  study: 'Mémoire insuffisante dans ce navigateur pour calculer les figures.',
  lens: 'Mémoire insuffisante dans ce navigateur pour la loupe.',
  rig: 'Les clips sont trop longs pour un rig dans ce navigateur. Raccourcissez-les.',
  map: 'Le fichier est trop volumineux pour ce navigateur. Utilisez la ligne de commande.',
  drawing: 'Le dessin est trop complexe pour ce navigateur. Simplifiez-le.',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `Impossible de charger le moteur de calcul : ${why}`,
  exportNotLoaded: (why) => `Impossible de démarrer l’export : ${why}`,
  status: (address, status) => `le serveur a répondu ${status} pour ${address}.`,
  isPage: (address) => `le serveur a envoyé une page web à la place de ${address}.`,
  absent: (address) =>
    `${address} est inaccessible. Vérifiez la connexion et la politique de sécurité de la page.`,
  incomplete: (address, detail) => `${address} est incomplet, ou ne peut pas fonctionner ici (${detail}).`,
  noWorkers:
    'Impossible de démarrer le moteur de calcul : ce navigateur ou cette page n’autorise pas les workers.',
  notStarted: (address) =>
    `Impossible de démarrer le moteur de calcul. Vérifiez que ${address} existe et que la page autorise les workers.`,
  exportNotStarted: (address) =>
    `Impossible de démarrer l’export. Vérifiez que ${address} existe et que la page autorise les workers.`,
  drawingNotChecked:
    'Ce dessin nécessite une partie de l’éditeur qui n’a pas pu être chargée. Vérifiez la connexion et que la page autorise les workers.',
  lostDrawing: 'Le moteur de calcul a échoué pendant le dessin.',
  released: 'Les pixels de l’image ne sont plus en mémoire. Ouvrez l’image de nouveau.',
};

/** Refusals of the solver, by their codes. */
export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `Le projet n’est pas valide : ${detail}`,
  picture: (detail) => `L’image ne convient pas : ${detail}`,
  'picture-mismatch': () => 'Le projet est fait pour une image d’une autre taille.',
  scale: () => 'L’export serait trop grand ou trop petit. Choisissez une autre taille.',
  canvas: () =>
    'L’image agrandie serait trop grande. Choisissez une taille plus petite, ou le cadre original.',
  'nothing-drawn': () => 'L’image est transparente partout.',
  'nothing-opaque': () =>
    'Aucune partie de l’image n’est assez opaque pour être déformée. Baissez l’opacité minimale.',
  'nothing-to-fill-from': () =>
    'La sélection ne laisse rien pour remplir le fond. Tracez-en une plus petite, ou désactivez le remplissage.',
  'no-outline': () => 'L’image n’a pas de partie transparente, donc pas de contour auquel ajuster un rig.',
  domain: (detail) => `Cette sélection n’est pas valide : ${detail}`,
  'handle-outside': (_, name) => `${quoted(name)} est hors de la forme. Placez la poignée sur l’image.`,
  'handle-far-outside': (_, name) =>
    `Ce rig ne convient pas à l’image : ${quoted(name)} serait loin en dehors.`,
  'handles-too-close': (_, name, other) =>
    `${quoted(name)} et ${quoted(other)} sont au même endroit. Déplacez ou supprimez l’une des deux.`,
  'bar-too-short': (_, name) =>
    `Deux sommets sont au même endroit dans ${quoted(name)}. Déplacez ou supprimez l’un des deux.`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `${quoted(name)} revient sur son propre tracé. Ses segments peuvent se croiser ou se toucher, mais pas se superposer.`
      : `${quoted(name)} et ${quoted(other)} se longent. Elles peuvent se croiser ou se toucher, mais pas se superposer.`,
  'on-held-boundary': (_, name) =>
    `${quoted(name)} est sur le contour verrouillé. Déplacez la poignée vers l’intérieur, ou déverrouillez le contour.`,
  'too-many-handles': () => 'Il y a trop de poignées. Supprimez-en.',
  'too-many-corners': (_, name) =>
    `Les barres et polygones ont trop de sommets. Tracez ${quoted(name)} avec moins de sommets.`,
  'handles-crowded': () =>
    'Trop de poignées sont très proches les unes des autres. Écartez-en, ou supprimez-en.',
  'outline-too-long': () =>
    'Ce contour a trop de fentes et de pointes. Tracez-en un plus simple, ou plus large.',
  'too-many-sites': () =>
    'Les poignées sont trop nombreuses ou trop proches. Écartez-en, ou réduisez le détail.',
  'too-much-memory': () =>
    'Cette déformation demande trop de mémoire pour un navigateur. Utilisez moins de poignées, ou moins de détail.',
  'too-much-work': () =>
    'Cette déformation est trop complexe pour être calculée en quelques secondes. Utilisez moins de poignées, ou un contour plus simple.',
  'held-too-fine': () =>
    'Ce contour a trop de sommets pour être verrouillé. Tracez-en un plus simple, ou déverrouillez le contour.',
  unsupported: (detail) => `Un réglage du projet n’est pas pris en charge : ${detail}`,
  pose: (detail) => `Cette pose n’est pas valide : ${detail}`,
  film: (detail) => `Le film ne peut pas être créé : ${detail}`,
  'point-outside': (detail) => `Ce point est hors de la forme : ${detail}`,
  mesh: (detail) => `Le maillage n’est pas valide : ${detail}`,
  cloud: (detail) => `Les points ne sont pas valides : ${detail}`,
  poser: (detail) => `Impossible de calculer la pose : ${detail}`,
};
