/** Node: PNG files are decoded here; programs pass a decoder for other formats. */

import { readFile } from 'node:fs/promises';
import { LATER, once, SOLVER } from '../compute/loading';
import type { Pixels } from '../compute/solution';
import { C2WarpError, ENGINE } from '../error';
import { readHeader } from '../io/formats/header';
import type { KindName } from '../io/formats/signature';
import { checkSize } from '../io/limits';
import { pictureErrors } from '../texts/en/picture_errors';
import type { Environment } from './environment';
import { pngPixels } from './png_pixels';
import type { WarpedImage } from './types';

const NO_WORKER = 'In Node, the solver runs on the calling thread. Call it from a worker thread instead.';

const loaded = (file: URL) => once(async () => WebAssembly.compile(await readFile(file)));

export const node: Environment = {
  usesWorker: false,
  loadModule: loaded(SOLVER),
  loadLater: loaded(LATER),

  spawn() {
    throw new C2WarpError(ENGINE, NO_WORKER);
  },

  async decode({ buffer }) {
    const { kind, name, size, end } = readHeader(buffer);
    if (kind !== 'png') throw new C2WarpError('picture', refusal(name));
    if (size) checkSize(size.width, size.height);
    if (end === 'missing')
      throw new C2WarpError('picture', 'The picture is incomplete: the end of the file is missing.');
    try {
      return pngPixels(buffer);
    } catch (cause) {
      const message = `The picture is damaged: ${(cause as Error).message}.`;
      throw new C2WarpError('picture', message, { cause });
    }
  },

  drawn: () => undefined,

  image: ({ width, height, rgba }: Pixels) =>
    ({ width, height, data: new Uint8ClampedArray(rgba.buffer) }) as WarpedImage,
};

const refusal = (name: KindName | undefined): string =>
  `This is ${name ? pictureErrors.kinds[name] : 'an unknown kind of file'}, but in Node only PNG is supported. Pass pixels as { width, height, data }, or a \`decode\` function.`;
