/** The harness page: gives the browser tests access to the modules below the editor. */
import { Engine } from '../../../web/src/compute/engine';
import { encodePng } from '../../../web/src/io/encode';
import { Renderer } from '../../../web/src/render/renderer';
import { drawnLegs } from './drawn_legs';
import { drawnPicture } from './drawn_picture';
import { decodePicture, openedPicture, pixelSource } from './pictures';
import { drawnTwice, startedEngine } from './scenes';

const parts = {
  Engine,
  Renderer,
  decodePicture,
  openedPicture,
  pixelSource,
  encodePng,
  drawnLegs,
  drawnPicture,
  drawnTwice,
  startedEngine,
};

declare global {
  /** Defined once the harness page has loaded. */
  var harness: typeof parts;
}

globalThis.harness = parts;
