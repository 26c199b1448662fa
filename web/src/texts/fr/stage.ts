/** The stage: its labels, hints, drawings, the brush, and the line below it. */
import type { Texts } from '../texts';
import { counted } from './language';

export const stage: Texts['stage'] = {
  keys: 'Les flèches déplacent la sélection. La virgule et le point la tournent et, avec Alt, changent son échelle.',
  noPicture: 'Aucune image',
  picture: (name) => `Image ${name}`,
  disabled: (picture) => `${picture}, désactivée`,
  posable: (picture) => `${picture}, à mettre en pose par ses poignées`,
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
  selectionCornerKeys: 'Les flèches le déplacent. Suppr le supprime, et C en ajoute un après lui.',
  pictureMenu: 'Image',
  cornerMenu: (corner, handle) => `${handle}, sommet ${corner}`,
};

export const hints: Texts['hints'] = {
  bar: {
    click: 'Faites glisser pour tracer une barre, ou cliquez ses sommets',
    tap: 'Faites glisser pour tracer une barre, ou touchez ses sommets',
  },
  polygon: {
    click: 'Tracez un polygone : cliquez ses sommets',
    tap: 'Tracez un polygone : touchez ses sommets',
  },
  lasso: {
    click: 'Entourez la partie à déformer : faites glisser, ou cliquez des sommets',
    tap: 'Entourez la partie à déformer : faites glisser, ou touchez des sommets',
  },
  lassoAgain: 'Faites glisser un sommet de la sélection, ou entourez une autre partie',
  select: {
    click: 'Prenez l’outil Point et cliquez sur l’image',
    tap: 'Prenez l’outil Point et touchez l’image',
  },
  point: {
    click: 'Cliquez sur l’image là où vous voulez la tenir',
    tap: 'Touchez l’image là où vous voulez la tenir',
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
  giveUp: 'Abandonner le tracé',
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
    bloat: 'Gonfler : étaler l’image',
    smooth: 'Lisser : égaliser ce que le pinceau a déplacé',
    restore: 'Restaurer : défaire des traits du pinceau',
    stiffen: 'Raidir : préserver la forme de certains endroits',
  },
  hints: {
    push: 'Faites glisser pour entraîner l’image.',
    pinch: 'Appuyez ou faites glisser pour resserrer l’image.',
    bloat: 'Appuyez ou faites glisser pour étaler l’image.',
    smooth: 'Faites glisser pour égaliser ce que le pinceau a déplacé.',
    restore: 'Faites glisser pour défaire des traits du pinceau.',
    stiffen: 'Passez sur les endroits qui doivent garder leur forme.',
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
  clearStiffness: 'Ôter la rigidité',
  clearStiffnessTip: 'Rendre l’image de nouveau souple',
  clearStrokes: 'Ôter les traits du pinceau',
  clearStrokesTip: 'Défaire tout ce que le pinceau a déplacé',
  holding: 'Les flèches poussent, Entrée relâche.',
  rigidOnly: 'La rigidité ne compte que dans la déformation rigide.',
  bendRigidly: 'Déformation rigide',
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
  samples: (count) => counted(count, 'échantillon'),
  virtualHandles: (count) => counted(count, 'poignée virtuelle', 'poignées virtuelles'),
};

/** Work that takes noticeable time. */
export const tasks: Texts['tasks'] = {
  opening: (name) => `Ouverture : ${name}`,
  start: 'Recherche du contour',
  domain: 'Échantillonnage',
  sampling: 'Mesure des distances',
  regions: 'Pondération',
  weights: 'Pondération',
  suggesting: 'Recherche d’emplacements de poignées',
  filling: 'Remplissage du fond',
  exporting: 'Export',
};
