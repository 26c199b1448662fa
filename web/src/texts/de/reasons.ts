import type { Texts } from '../texts';

export const reasons: Texts['reasons'] = {
  disabled: 'Der Editor ist deaktiviert',
  leftOut: 'Diese Seite bietet es nicht an',
  viewOnly: 'Dieses Bild ist nur zum Ansehen',
  noPicture: 'Zuerst ein Bild öffnen',
  noHandles: 'Es gibt noch keinen Griff',
  noneSelected: 'Zuerst einen Griff auswählen',
  noSingle: 'Einen einzelnen Griff auswählen',
  noLine: 'Einen einzelnen Stab oder ein einzelnes Polygon auswählen',
  nothingToUndo: 'Es gibt nichts rückgängig zu machen',
  nothingToRedo: 'Es gibt nichts zu wiederholen',
  atRest: 'Schon in Ruhe',
  inFront: 'Schon ganz vorn',
  atBack: 'Schon ganz hinten',
  nothingFolded: 'Nichts ist gefaltet',
  noLasso: 'Zuerst einen Teil mit dem Lasso umfahren',
  notOpaque: 'Nur Bilder ohne Transparenz haben einen Rahmen zum Festhalten',
  nothingBends: 'Hier biegt sich nichts',
  noClipOpen: 'Kein Clip ist offen.',
  cornersNeeded: {
    bar: (count) => `Ein Stab braucht ${count} Ecken`,
    polygon: (count) => `Ein Polygon braucht ${count} Ecken`,
  },
};
