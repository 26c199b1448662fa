/** Errors that people see. Each area is a file of its own where a worker needs it alone. */
import { addressErrors, carriedErrors, pictureErrors } from './picture_errors';
import { engineErrors, refusals, tooMuchErrors } from './solver_errors';
import { writingErrors } from './writing_errors';

export const errors = {
  picture: pictureErrors,
  address: addressErrors,
  carried: carriedErrors,
  tooMuch: tooMuchErrors,
  engine: engineErrors,
  refusals,
  writing: writingErrors,
  /** After a sentence about a step that cannot be solved. */
  takenBack: 'The step was undone.',
  /** @param file whose error it is. */
  inFile: (file: string, sentence: string) => `${file}: ${sentence}`,
  nothingOpaque: (picture: string) => `${picture}: no part of this picture is opaque enough to warp.`,
  pictureTooMuch: (picture: string) => `${picture} is too large to process in this browser. Scale it down.`,
  /** A project for a picture of the first size, and the open picture with its size. */
  imageSize: (width: number, height: number, picture: string, itsWidth: number, itsHeight: number) =>
    `The project is for a picture of ${width} × ${height} px, but ${picture} has ${itsWidth} × ${itsHeight} px.`,
  emptyProject: 'The file is empty.',
  /** An export that cannot hold this project. @param detail a sentence of the solver, in English. */
  exportRefused: (detail: string) => detail,
  cardNotLoaded: 'Could not load this panel. Check your connection.',
  noWebgl: 'This browser cannot draw with WebGL2. Turn on hardware acceleration or use another browser.',
  noCanvas: 'This browser cannot show pictures on a 2D canvas.',
  /** Anything else. @param detail a message of the browser or of a program, in English. */
  other: (detail: string) => detail,
};
