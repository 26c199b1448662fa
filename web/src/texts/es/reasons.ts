/** Why a command cannot run now, in a few words: for menus and screen readers. */
import type { Texts } from '../texts';

export const reasons: Texts['reasons'] = {
  disabled: 'El editor está desactivado',
  leftOut: 'Esta página no lo incluye',
  viewOnly: 'Esta imagen es solo para ver',
  noPicture: 'Primero hay que abrir una imagen',
  noHandles: 'Aún no hay puntos de control',
  noneSelected: 'Primero hay que seleccionar un punto de control',
  noSingle: 'Hay que seleccionar un solo punto de control',
  noLine: 'Hay que seleccionar una sola barra o un solo polígono',
  nothingToUndo: 'No hay nada que deshacer',
  nothingToRedo: 'No hay nada que rehacer',
  atRest: 'Ya en reposo',
  inFront: 'Ya delante',
  atBack: 'Ya al fondo',
  nothingFolded: 'No hay pliegues',
  noLasso: 'Primero hay que rodear una parte con el lazo',
  notOpaque: 'Solo las imágenes sin transparencia tienen un borde que sujetar',
  nothingBends: 'Aquí no se deforma nada',
  noClipOpen: 'No hay ningún clip abierto.',
  cornersNeeded: {
    bar: (count) => `Una barra necesita ${count} esquinas`,
    polygon: (count) => `Un polígono necesita ${count} esquinas`,
  },
};
