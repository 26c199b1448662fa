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
  takenBack: 'Der Schritt wurde zurückgenommen.',
  inFile: (file, sentence) => `${file}: ${sentence}`,
  nothingOpaque: (picture) => `${picture}: Nichts in diesem Bild ist deckend genug, um verbogen zu werden.`,
  pictureTooMuch: (picture) => `${picture}: Dieses Bild ist zu viel für den Löser in diesem Browser.`,
  imageSize: (width, height, picture, itsWidth, itsHeight) =>
    `Das Projekt ist für ein Bild von ${width} × ${height} px; ${picture} hat ${itsWidth} × ${itsHeight} px.`,
  emptyProject: 'Die Datei ist leer.',
  exportRefused: (detail) => `Der Export ist nicht möglich: ${detail}`,
  cardNotLoaded: 'Diese Karte konnte nicht geladen werden: Ist das Netz da?',
  noWebgl:
    'Dieser Browser kann nicht mit WebGL2 zeichnen. Hardwarebeschleunigung einschalten oder einen anderen Browser verwenden.',
  noCanvas: 'Dieser Browser kann kein Bild auf einer 2D-Zeichenfläche zeigen.',
  other: (detail) => `Es gab einen Fehler: ${detail}`,
};
