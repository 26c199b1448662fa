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
  nothingOpaque: (picture) => `${picture}: nada en esta imagen es lo bastante opaco para deformarse.`,
  pictureTooMuch: (picture) =>
    `${picture}: esta imagen es más de lo que se puede calcular en este navegador.`,
  imageSize: (width, height, picture, itsWidth, itsHeight) =>
    `El proyecto es para una imagen de ${width} × ${height} px; ${picture} tiene ${itsWidth} × ${itsHeight} px.`,
  emptyProject: 'El archivo está vacío.',
  exportRefused: (detail) => `La exportación no es posible: ${detail}`,
  cardNotLoaded: 'No se ha podido cargar esta tarjeta: ¿hay red?',
  noWebgl:
    'Este navegador no puede dibujar con WebGL2. Hay que activar la aceleración por hardware o usar otro navegador.',
  noCanvas: 'Este navegador no puede mostrar una imagen en un lienzo 2D.',
  other: (detail) => `Ha ocurrido un error: ${detail}`,
};
