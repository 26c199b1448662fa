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
  takenBack: 'Der Schritt wurde rückgängig gemacht.',
  inFile: (file, sentence) => `${file}: ${sentence}`,
  nothingOpaque: (picture) => `${picture}: Kein Teil dieses Bilds ist deckend genug zum Biegen.`,
  pictureTooMuch: (picture) => `${picture} ist zu groß für diesen Browser. Verkleinern Sie das Bild.`,
  imageSize: (width, height, picture, itsWidth, itsHeight) =>
    `Das Projekt ist für ein Bild von ${width} × ${height} px, aber ${picture} hat ${itsWidth} × ${itsHeight} px.`,
  emptyProject: 'Die Datei ist leer.',
  exportRefused: (detail) => `Der Export ist nicht möglich: ${detail}`,
  cardNotLoaded: 'Dieser Bereich konnte nicht geladen werden. Prüfen Sie die Verbindung.',
  noWebgl:
    'Dieser Browser kann nicht mit WebGL2 zeichnen. Schalten Sie die Hardwarebeschleunigung ein, oder verwenden Sie einen anderen Browser.',
  noCanvas: 'Dieser Browser kann keine Bilder auf einem 2D-Canvas anzeigen.',
  other: (detail) => `Ein Fehler ist aufgetreten: ${detail}`,
};
