/** Errors that people see. */
import type { Texts } from '../texts';
import { addressErrors, carriedErrors, pictureErrors } from './picture_errors';
import { engineErrors, refusals, tooMuchErrors } from './solver_errors';
import { writingErrors } from './writing_errors';

export const errors: Texts['errors'] = {
  picture: pictureErrors,
  address: addressErrors,
  carried: carriedErrors,
  tooMuch: tooMuchErrors,
  engine: engineErrors,
  refusals,
  writing: writingErrors,
  takenBack: 'Se ha deshecho el paso.',
  inFile: (file, sentence) => `${file}: ${sentence}`,
  nothingOpaque: (picture) =>
    `${picture}: ninguna parte de esta imagen es lo bastante opaca para deformarla.`,
  pictureTooMuch: (picture) =>
    `${picture} es demasiado grande para procesarla en este navegador. Reduzca la imagen.`,
  imageSize: (width, height, picture, itsWidth, itsHeight) =>
    `El proyecto es para una imagen de ${width} × ${height} px, pero ${picture} tiene ${itsWidth} × ${itsHeight} px.`,
  emptyProject: 'El archivo está vacío.',
  exportRefused: (detail) => `La exportación no es posible: ${detail}`,
  cardNotLoaded: 'No se ha podido cargar este panel. Compruebe la conexión.',
  noWebgl:
    'Este navegador no puede dibujar con WebGL2. Active la aceleración por hardware o use otro navegador.',
  noCanvas: 'Este navegador no puede mostrar imágenes en un lienzo 2D.',
  other: (detail) => `Ha ocurrido un error: ${detail}`,
};
