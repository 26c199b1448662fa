/** Errors of the solver and its worker. */
import type { Texts } from '../texts';
import { quoted } from './language';

/** Why something is more than the solver can do, mostly for want of memory. */
export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: 'L’image demande plus de mémoire qu’il n’y en a : réduisez-la.',
  pictures: 'Les images demandent plus de mémoire qu’il n’y en a : réduisez-les.',
  suggest: 'L’image demande trop de mémoire pour suggérer des poignées : réduisez-la.',
  solve: 'C’est plus que le solveur ne peut faire avec la mémoire disponible.',
  fill: 'L’image demande trop de mémoire pour remplir le fond : réduisez-la.',
  draw: 'Le dessin de l’image demande plus de mémoire qu’il n’y en a.',
  film: 'Le dessin du film demande plus de mémoire que ce navigateur n’en donne.',
  points: 'Les points demandent plus de mémoire qu’il n’y en a.',
  cells: 'Les cellules dépassent ce que le solveur peut faire dans ce navigateur.',
  study: 'Les figures dépassent ce que le solveur peut faire dans ce navigateur.',
  lens: 'La loupe dépasse ce que le solveur peut faire dans ce navigateur.',
  rig: 'Les clips dépassent ce qu’un rig peut contenir dans ce navigateur : raccourcissez-les.',
  map: 'Le fichier dépasse ce que ce navigateur peut contenir : la ligne de commande l’écrit.',
  drawing: 'Le dessin dépasse ce que ce navigateur peut déformer : simplifiez-le.',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `Le solveur n’a pas pu être chargé : ${why}`,
  exportNotLoaded: (why) => `L’export n’a pas pu démarrer : ${why}`,
  status: (address, status) => `${address} répond ${status}`,
  isPage: (address) => `${address} est absent : une page se trouve à sa place`,
  absent: (address) => `${address} n’arrive pas : le réseau est-il là, et la page le permet-elle ?`,
  incomplete: (address, detail) =>
    `${address} est arrivé incomplet, ou ne peut pas fonctionner ici (${detail}).`,
  noWorkers: 'Le solveur n’a pas pu démarrer : ce navigateur ou cette page n’autorise pas les workers.',
  notStarted: (address) =>
    `Le solveur a échoué : son worker n’a pas pu démarrer. ${address} est-il là, et la page le permet-elle ?`,
  exportNotStarted: (address) =>
    `L’export n’a pas pu démarrer : ${address} est-il là, et la page autorise-t-elle les workers ?`,
  lostDrawing: 'Le solveur a échoué pendant le dessin.',
  released:
    'Les pixels de l’image ont disparu, ou la mémoire manque pour les garder. Ouvrez l’image à nouveau.',
};

/** Refusals of the solver, by their codes. */
export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `Le projet n’est pas valide : ${detail}`,
  picture: (detail) => `L’image ne convient pas : ${detail}`,
  'picture-mismatch': () => 'Le projet est fait pour une image d’une autre taille.',
  scale: () => 'L’export serait trop grand ou trop petit : choisissez une autre taille.',
  canvas: () =>
    'L’image entière serait trop grande : choisissez une taille plus petite, ou le rectangle de l’original.',
  'nothing-drawn': () => 'Rien n’est couvert : l’image est transparente partout.',
  'nothing-opaque': () =>
    'Rien dans cette image n’est assez opaque pour être déformé : baissez l’opacité minimale.',
  'nothing-to-fill-from': () =>
    'Il ne reste rien autour de la sélection pour remplir son fond : tracez-en une plus petite, ou laissez le fond vide.',
  'no-outline': () => 'L’image n’a pas de partie transparente, donc pas de contour auquel ajuster un rig.',
  domain: (detail) => `Cette sélection n’est pas valide : ${detail}`,
  'handle-outside': (_, name) => `${quoted(name)} est hors de la forme : placez la poignée sur l’image.`,
  'handle-far-outside': (_, name) =>
    `${quoted(name)} serait loin hors de cette image : le rig ne lui convient pas.`,
  'handles-too-close': (_, name, other) =>
    `${quoted(name)} et ${quoted(other)} sont au même endroit : déplacez ou supprimez l’une des deux.`,
  'bar-too-short': (_, name) =>
    `Deux sommets sont au même endroit dans ${quoted(name)} : déplacez ou supprimez l’un des deux.`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `${quoted(name)} revient le long de son propre tracé : ses segments peuvent se croiser et se toucher, mais pas se superposer.`
      : `${quoted(name)} et ${quoted(other)} se longent : elles peuvent se croiser et se toucher, mais pas se superposer.`,
  'on-held-boundary': (_, name) =>
    `${quoted(name)} est sur le bord, qui est maintenu : éloignez la poignée du bord, ou libérez le bord.`,
  'too-many-handles': () => 'Il y a plus de poignées que le solveur n’en accepte : supprimez-en.',
  'too-many-corners': (_, name) =>
    `Les barres et polygones ont plus de sommets que le solveur n’en accepte : tracez ${quoted(name)} avec moins de sommets.`,
  'handles-crowded': () =>
    'Trop de poignées sont très proches les unes des autres : écartez-en, ou supprimez-en.',
  'outline-too-long': () =>
    'Ce contour a trop de fentes et de pointes : tracez-en un plus simple, ou plus large.',
  'too-many-sites': () =>
    'Les poignées sont trop proches les unes des autres, ou trop nombreuses : écartez-en, ou réduisez le détail.',
  'too-much-memory': () =>
    'Cela demande plus de mémoire qu’un navigateur n’en a : utilisez moins de poignées, ou moins de détail.',
  'too-much-work': () =>
    'C’est trop complexe pour être résolu en quelques secondes : utilisez moins de poignées, ou un contour plus simple.',
  'held-too-fine': () =>
    'Ce contour a trop de sommets pour être maintenu : tracez-en un plus simple, ou laissez-le bouger.',
  unsupported: (detail) => `Un réglage du projet n’est pas pris en charge : ${detail}`,
  pose: (detail) => `Cette pose n’est pas valide : ${detail}`,
  film: (detail) => `Le film ne peut pas être créé : ${detail}`,
  'point-outside': (detail) => `Ce point est hors de la forme : ${detail}`,
  mesh: (detail) => `Le maillage n’est pas valide : ${detail}`,
  cloud: (detail) => `Les points ne sont pas valides : ${detail}`,
  poser: (detail) => `La mise en pose a échoué : ${detail}`,
};
