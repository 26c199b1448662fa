/**
 * Writes picture files, row by row, in a worker that all editors of a page share.
 *
 * A PNG file holds exactly the bytes that the solver returns, in straight alpha.
 */

import { sharedWorker } from '../start_worker';
import { say, type Wording } from '../texts/wording';
import type { BeginFile, FileSettings, PictureType } from './encoding';
import { FileWriter } from './file_writer';
import encoder from './worker/encoder?worker&url';
import { writingError } from './writing_error';

export type { FileSettings, PictureType, PngChunk } from './encoding';

export const TYPE_NAMES = {
  'image/png': 'PNG',
  'image/jpeg': 'JPEG',
  'image/webp': 'WebP',
} as const satisfies Record<PictureType, string>;

/** Starts the worker, also ahead of time, so that a later export needs no network. */
export const prepareEncoder = sharedWorker(encoder);

/** A file that takes rows from top to bottom. Dispose of it at the end. */
export class PictureFile extends FileWriter<Blob> {
  constructor(settings: FileSettings) {
    const worker = prepareEncoder();
    const failed = (reason: Wording) =>
      writingError('failed', say('errors.writing.picture', TYPE_NAMES[settings.type], reason));
    super(
      worker,
      (port) => worker.postMessage({ settings, port } satisfies BeginFile, [port]),
      (refusal) => failed(refusal?.refused ?? say('errors.writing.reasons.encoderFailed')),
    );
  }
}
