/** The harness page: gives the browser tests access to the modules below the editor. */
import { Engine } from '../../../web/src/compute/engine';
import { PictureFile } from '../../../web/src/io/encoder';
import { Renderer } from '../../../web/src/render/renderer';
import { drawnGlow } from './drawn_glow';
import { drawnLegs } from './drawn_legs';
import { drawnPicture } from './drawn_picture';
import { encodePng } from './encoded';
import { decodePicture, openedPicture, pixelSource } from './pictures';
import { drawnPixels, drawnTwice, startedEngine } from './scenes';

const parts = {
  Engine,
  PictureFile,
  Renderer,
  decodePicture,
  openedPicture,
  pixelSource,
  encodePng,
  drawnGlow,
  drawnLegs,
  drawnPicture,
  drawnPixels,
  drawnTwice,
  startedEngine,
  /** With the whole editor, which other tests do without. */
  pseudo: () => import('./pseudo'),
};

declare global {
  /** Defined once the harness page has loaded. */
  var harness: typeof parts;
}

globalThis.harness = parts;
