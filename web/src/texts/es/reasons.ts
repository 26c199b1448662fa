/** Why a command cannot run now, in a few words: for menus and screen readers. */
import type { Texts } from '../texts';

export const reasons: Texts['reasons'] = {
  disabled: 'El editor está desactivado',
  leftOut: 'No disponible en esta página',
  viewOnly: 'Esta imagen es de solo lectura',
  noPicture: 'Abra primero una imagen',
  noHandles: 'Añada primero un punto de control',
  noneSelected: 'Seleccione primero un punto de control',
  noSingle: 'Seleccione un solo punto de control',
  noLine: 'Seleccione una sola barra o un solo polígono',
  nothingToUndo: 'Nada que deshacer',
  nothingToRedo: 'Nada que rehacer',
  atRest: 'Ya está en la posición inicial',
  inFront: 'Ya está delante',
  atBack: 'Ya está al fondo',
  nothingFolded: 'No hay pliegues',
  noLasso: 'Rodee primero una parte con el lazo',
  notOpaque: 'Solo funciona en imágenes sin transparencia',
  nothingBends: 'Aquí no se deforma nada',
  noClipOpen: 'Abra primero un clip',
  cornersNeeded: {
    bar: (count) => `Una barra necesita al menos ${count} esquinas`,
    polygon: (count) => `Un polígono necesita al menos ${count} esquinas`,
  },
};
