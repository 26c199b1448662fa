/** Why a command cannot run now, in a few words: for menus and screen readers. */
import type { Texts } from '../texts';

export const reasons: Texts['reasons'] = {
  disabled: 'L’éditeur est désactivé',
  leftOut: 'Non disponible sur cette page',
  viewOnly: 'Cette image est en lecture seule',
  noPicture: 'Ouvrez d’abord une image',
  noHandles: 'Ajoutez d’abord une poignée',
  noneSelected: 'Sélectionnez d’abord une poignée',
  noSingle: 'Sélectionnez une seule poignée',
  noLine: 'Sélectionnez une seule barre ou un seul polygone',
  nothingToUndo: 'Rien à annuler',
  nothingToRedo: 'Rien à rétablir',
  atRest: 'Déjà à la position initiale',
  inFront: 'Déjà au premier plan',
  atBack: 'Déjà à l’arrière-plan',
  nothingFolded: 'Aucun pli',
  noLasso: 'Entourez d’abord une partie au lasso',
  notOpaque: 'Seulement dans les images sans transparence',
  nothingBends: 'Rien ne se déforme ici',
  noClipOpen: 'Ouvrez d’abord un clip',
  cornersNeeded: {
    bar: (count) => `Une barre a besoin d’au moins ${count} sommets`,
    polygon: (count) => `Un polygone a besoin d’au moins ${count} sommets`,
  },
};
