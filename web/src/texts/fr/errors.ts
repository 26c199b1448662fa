/** Errors that people see. Each area is a file of its own where a worker needs it alone. */
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
  takenBack: 'L’étape a été annulée.',
  inFile: (file, sentence) => `${file} : ${sentence}`,
  nothingOpaque: (picture) => `${picture} : rien dans cette image n’est assez opaque pour être déformé.`,
  pictureTooMuch: (picture) =>
    `${picture} : cette image dépasse ce que le solveur peut faire dans ce navigateur.`,
  imageSize: (width, height, picture, itsWidth, itsHeight) =>
    `Le projet est fait pour une image de ${width} × ${height} px ; ${picture} fait ${itsWidth} × ${itsHeight} px.`,
  emptyProject: 'Le fichier est vide.',
  exportRefused: (detail) => `L’export n’est pas possible : ${detail}`,
  cardNotLoaded: 'Cette fiche n’a pas pu être chargée : le réseau est-il là ?',
  noWebgl:
    'Ce navigateur ne peut pas dessiner avec WebGL2. Activez l’accélération matérielle ou utilisez un autre navigateur.',
  noCanvas: 'Ce navigateur ne peut pas afficher d’image sur un canevas 2D.',
  other: (detail) => `Erreur : ${detail}`,
};
