/** Writes films, frame by frame, in a worker that all editors of a page share. */
import { sharedWorker } from '../start_worker';
import { FileWriter } from './file_writer';
import type { BeginFilm, FilmSettings, FilmTarget } from './filming';
import writer from './worker/film?worker&url';
import type { Refusal, WriteFault } from './writing';

const prepareFilmWriter = sharedWorker(writer);

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
    const worker = prepareFilmWriter();
    const transfer = picture ? [picture.buffer] : [];
    super(
      worker,
      (port) =>
        worker.postMessage({ settings, picture, target, port } satisfies BeginFilm, [port, ...transfer]),
      ({ refused, fault } = STOPPED) => new Error(`${FAULTS[fault]}: ${refused}`),
    );
  }
}
