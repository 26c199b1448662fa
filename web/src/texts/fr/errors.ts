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
  nothingOpaque: (picture) =>
    `${picture} : aucune partie de cette image n’est assez opaque pour être déformée.`,
  pictureTooMuch: (picture) => `${picture} est trop grand pour ce navigateur. Réduisez l’image.`,
  imageSize: (width, height, picture, itsWidth, itsHeight) =>
    `Le projet est fait pour une image de ${width} × ${height} px, mais ${picture} fait ${itsWidth} × ${itsHeight} px.`,
  emptyProject: 'Le fichier est vide.',
  exportRefused: (detail) => `L’export n’est pas possible : ${detail}`,
  cardNotLoaded: 'Impossible de charger ce panneau. Vérifiez la connexion.',
  noWebgl:
    'Ce navigateur ne peut pas dessiner avec WebGL2. Activez l’accélération matérielle ou utilisez un autre navigateur.',
  noCanvas: 'Ce navigateur ne peut pas afficher d’images sur un canevas 2D.',
  other: (detail) => `Une erreur s’est produite : ${detail}`,
};
