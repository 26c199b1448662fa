/** Writes films, frame by frame, in workers that all editors of a page share. */
import { sharedWorker } from '../start_worker';
import { FileWriter } from './file_writer';
import type { BeginFilm, FilmFormat, FilmSettings, FilmTarget } from './filming';
import animations from './worker/animations?worker&url';
import videos from './worker/videos?worker&url';
import zips from './worker/zips?worker&url';
import type { Refusal, WriteFault } from './writing';

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

const FAULTS: Readonly<Record<WriteFault, string>> = {
  encoder: 'The film could not be encoded',
  storage: 'The film could not be saved',
};

const STOPPED: Refusal = {
  refused: 'the encoder stopped or did not load. Reload the page.',
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
      ({ refused, fault } = STOPPED) => new Error(`${FAULTS[fault]}: ${refused}`),
    );
  }
}
