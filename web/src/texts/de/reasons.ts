import type { Texts } from '../texts';

export const reasons: Texts['reasons'] = {
  disabled: 'Der Editor ist deaktiviert',
  leftOut: 'Auf dieser Seite nicht verfügbar',
  viewOnly: 'Dieses Bild lässt sich nur ansehen',
  noPicture: 'Zuerst ein Bild öffnen',
  noHandles: 'Zuerst einen Griff hinzufügen',
  noneSelected: 'Zuerst einen Griff auswählen',
  noSingle: 'Einen einzelnen Griff auswählen',
  noLine: 'Einen einzelnen Stab oder ein einzelnes Polygon auswählen',
  nothingToUndo: 'Nichts rückgängig zu machen',
  nothingToRedo: 'Nichts zu wiederholen',
  atRest: 'Schon in der Ausgangslage',
  inFront: 'Schon ganz vorn',
  atBack: 'Schon ganz hinten',
  nothingFolded: 'Nichts ist gefaltet',
  noLasso: 'Zuerst einen Teil mit dem Lasso umfahren',
  notOpaque: 'Nur in Bildern ohne Transparenz möglich',
  nothingBends: 'Hier biegt sich nichts',
  noClipOpen: 'Zuerst einen Clip öffnen',
  cornersNeeded: {
    bar: (count) => `Ein Stab braucht mindestens ${count} Ecken`,
    polygon: (count) => `Ein Polygon braucht mindestens ${count} Ecken`,
  },
};
