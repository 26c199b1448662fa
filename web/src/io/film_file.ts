/** Writes films, frame by frame, in workers that all editors of a page share. */

import { sharedWorker } from '../start_worker';
import { say } from '../texts/wording';
import { FileWriter } from './file_writer';
import type { BeginFilm, FilmFormat, FilmSettings, FilmTarget } from './filming';
import animations from './worker/animations?worker&url';
import videos from './worker/videos?worker&url';
import zips from './worker/zips?worker&url';
import type { Refusal, WriteFault } from './writing';
import { writingError } from './writing_error';

const ENCODER = new URL('./generated/film_bg.wasm', import.meta.url);

const animationWriter = sharedWorker(animations);
const videoWriter = sharedWorker(videos);
const zipWriter = sharedWorker(zips);

const WRITERS: Readonly<Record<FilmFormat, () => Worker>> = {
  webm: videoWriter,
  mp4: videoWriter,
  gif: animationWriter,
  apng: animationWriter,
  webp: animationWriter,
  frames: zipWriter,
  sheet: zipWriter,
};

const FAULTS = {
  encoder: 'errors.writing.film',
  storage: 'errors.writing.filmStorage',
} as const satisfies Record<WriteFault, string>;

const STOPPED: Refusal = {
  refused: say('errors.writing.reasons.encoderStopped'),
  fault: 'encoder',
};

/** A film that takes frames. At the end it is null if it is in the picked file. Dispose of it at the end. */
export class FilmFile extends FileWriter<Blob | null> {
  /** @param picture see `BeginFilm`. Transferred to the worker. */
  constructor(settings: FilmSettings, picture: Uint8Array<ArrayBuffer> | null, target: FilmTarget) {
    const worker = WRITERS[settings.format]();
    const transfer = picture ? [picture.buffer] : [];
    super(
      worker,
      (port) =>
        worker.postMessage({ settings, picture, target, encoder: ENCODER.href, port } satisfies BeginFilm, [
          port,
          ...transfer,
        ]),
      ({ refused, fault } = STOPPED) => writingError('failed', say(FAULTS[fault], refused)),
    );
  }
}
