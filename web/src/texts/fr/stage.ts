/** The stage: its labels, hints, drawings, the brush, and the line below it. */
import type { Texts } from '../texts';
import { counted } from './language';

export const stage: Texts['stage'] = {
  keys: 'Les flèches déplacent la sélection. La virgule et le point la tournent et, avec Alt, changent son échelle.',
  noPicture: 'Aucune image',
  picture: (name) => `Image ${name}`,
  disabled: (picture) => `${picture}, désactivée`,
  posable: (picture) => `${picture}, avec des poignées pour la bouger`,
  original: 'Original',
  opening: 'Ouverture…',
  drop: 'Déposez une image ici, collez-en une, ou',
  openPicture: 'Ouvrir une image',
  required: 'Ouvrez une image.',
  wouldFold: 'ferait un pli ici',
  dismiss: 'Fermer',
  handles: 'Poignées',
  selectionCorners: 'Sommets de la sélection',
  selectionCorner: (corner, part, x, y) =>
    `Sommet ${corner} de ${part === null ? 'la sélection' : `la partie ${part} de la sélection`}, x ${x}, y ${y}`,
  selectionCornerKeys: 'Les flèches déplacent le sommet. Suppr le supprime, et C en ajoute un après lui.',
  pictureMenu: 'Image',
  cornerMenu: (corner, handle) => `${handle}, sommet ${corner}`,
};

export const hints: Texts['hints'] = {
  bar: {
    click: 'Faites glisser pour tracer une barre, ou cliquez sur ses sommets',
    tap: 'Faites glisser pour tracer une barre, ou touchez ses sommets',
  },
  polygon: {
    click: 'Cliquez sur les sommets du polygone',
    tap: 'Touchez les sommets du polygone',
  },
  lasso: {
    click: 'Entourez la partie à déformer : faites glisser, ou cliquez sur les sommets',
    tap: 'Entourez la partie à déformer : faites glisser, ou touchez les sommets',
  },
  lassoAgain: 'Faites glisser un sommet de la sélection, ou entourez une autre partie',
  select: {
    click: 'Choisissez l’outil Point, puis cliquez sur l’image',
    tap: 'Choisissez l’outil Point, puis touchez l’image',
  },
  point: {
    click: 'Cliquez sur l’image là où vous voulez une poignée',
    tap: 'Touchez l’image là où vous voulez une poignée',
  },
  snapToEdges: 'Aimanter aux bords',
  snapToEdgesTip: 'Le lasso suit les bords de l’image. Maintenez Alt pour tracer librement',
};

export const drawing: Texts['drawing'] = {
  label: 'Tracé',
  ready: 'Ajoutez des sommets, ou terminez',
  oneMore: 'Encore un sommet',
  more: (count) => `Encore ${counted(count, 'sommet')}`,
  takeBack: 'Retirer le dernier sommet',
  giveUp: 'Annuler le tracé',
  finish: 'Terminer',
};

export const brush: Texts['brush'] = {
  label: 'Pinceau',
  effect: 'Effet du pinceau',
  kinds: {
    push: 'Pousser',
    pinch: 'Pincer',
    bloat: 'Gonfler',
    smooth: 'Lisser',
    restore: 'Restaurer',
    stiffen: 'Raidir',
  },
  tips: {
    push: 'Pousser : entraîner l’image',
    pinch: 'Pincer : resserrer l’image',
    bloat: 'Gonfler : pousser l’image vers l’extérieur',
    smooth: 'Lisser : égaliser les traits du pinceau',
    restore: 'Restaurer : retirer les traits du pinceau',
    stiffen: 'Raidir : garder des zones rigides',
  },
  hints: {
    push: 'Faites glisser pour entraîner l’image.',
    pinch: 'Appuyez ou faites glisser pour resserrer l’image.',
    bloat: 'Appuyez ou faites glisser pour pousser l’image vers l’extérieur.',
    smooth: 'Faites glisser pour égaliser les traits du pinceau.',
    restore: 'Faites glisser pour retirer les traits du pinceau.',
    stiffen: 'Faites glisser sur les zones à garder rigides.',
  },
  altHints: {
    push: 'Alt restaure.',
    pinch: 'Alt gonfle.',
    bloat: 'Alt pince.',
    smooth: '',
    restore: 'Alt pousse.',
    stiffen: 'Alt efface.',
  },
  size: 'Taille',
  strength: 'Force',
  sizeLabel: 'Taille du pinceau (%)',
  strengthLabel: 'Force du pinceau (%)',
  erase: 'Effacer',
  eraseTip: 'Effacer la rigidité',
  clearStiffness: 'Retirer la rigidité',
  clearStiffnessTip: 'Rendre toute l’image de nouveau souple',
  clearStrokes: 'Retirer les traits du pinceau',
  clearStrokesTip: 'Retirer tous les traits du pinceau de l’image',
  holding: 'Les flèches poussent, Entrée relâche.',
  rigidOnly: 'La rigidité n’agit qu’en mode rigide.',
  bendRigidly: 'Passer en mode rigide',
};

/** The line at the bottom. */
export const status: Texts['status'] = {
  label: 'État',
  hasCreases: 'L’image a des plis',
  privacy: 'Rien ne quitte votre navigateur',
  privacyTip: 'Les images sont ouvertes, déformées et enregistrées sur cet appareil seulement.',
  view: 'Vue',
  zoom: 'Zoom',
  seeIt: 'Voir',
  out: 'Moins',
  in: 'Plus',
  fit: 'Ajuster',
  actual: 'Réelle',
  stoppedAtFold: 'Arrêté à un pli',
  creases: (count) => counted(count, 'pli'),
  creasesAnd: (creases, effect) => `${creases}. ${effect}`,
  hideCreases: 'Masquer les plis',
  showCreases: 'Afficher les plis',
  zoomToCrease: 'Zoomer sur le pli',
  zoomToNextCrease: 'Zoomer sur le pli suivant',
  cancel: 'Annuler',
  samples: (count) => counted(count, 'point de maillage', 'points de maillage'),
  virtualHandles: (count) => counted(count, 'point auxiliaire', 'points auxiliaires'),
};

/** Work that takes noticeable time. */
export const tasks: Texts['tasks'] = {
  opening: (name) => `Ouverture : ${name}`,
  start: 'Recherche du contour',
  domain: 'Création du maillage',
  sampling: 'Mesure des distances',
  regions: 'Calcul des poids',
  weights: 'Calcul des poids',
  suggesting: 'Recherche d’emplacements de poignées',
  filling: 'Remplissage du fond',
  exporting: 'Export',
};
