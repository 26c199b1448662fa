/** Why a command cannot run now, in a few words: for menus and screen readers. */
import type { Texts } from '../texts';

export const reasons: Texts['reasons'] = {
  disabled: 'L’éditeur est désactivé',
  leftOut: 'Cette page ne le propose pas',
  viewOnly: 'Cette image est en lecture seule',
  noPicture: 'Ouvrez d’abord une image',
  noHandles: 'Il n’y a pas encore de poignée',
  noneSelected: 'Sélectionnez d’abord une poignée',
  noSingle: 'Sélectionnez une seule poignée',
  noLine: 'Sélectionnez une seule barre ou un seul polygone',
  nothingToUndo: 'Il n’y a rien à annuler',
  nothingToRedo: 'Il n’y a rien à rétablir',
  atRest: 'Déjà au repos',
  inFront: 'Déjà au premier plan',
  atBack: 'Déjà à l’arrière-plan',
  nothingFolded: 'Il n’y a pas de pli',
  noLasso: 'Entourez d’abord une partie au lasso',
  notOpaque: 'Seules les images sans transparence ont un cadre à maintenir',
  nothingBends: 'Rien ne se déforme ici',
  noClipOpen: 'Aucun clip n’est ouvert.',
  cornersNeeded: {
    bar: (count) => `Il faut ${count} sommets à une barre`,
    polygon: (count) => `Il faut ${count} sommets à un polygone`,
  },
};
