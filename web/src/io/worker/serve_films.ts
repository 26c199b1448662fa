/**
 * Writes films from frames, in a worker. There is a worker for each kind of encoder: bundlers copy a worker as one
 * file, without parts that it would load later.
 */
import type { BeginFilm, FilmSettings } from '../filming';
import type { FilmEncoder } from './film_encoder';
import { BlobOutput, type FilmOutput, PickedOutput } from './film_output';
import { opaqueOver } from './opaque_over';
import { serveFile } from './serve_file';
import type { WrittenFile } from './written_file';

declare const self: DedicatedWorkerGlobalScope;

const TYPES: Readonly<Record<FilmSettings['format'], string>> = {
  webm: 'video/webm',
  mp4: 'video/mp4',
  gif: 'image/gif',
  apng: 'image/png',
  webp: 'image/webp',
  frames: 'application/zip',
  sheet: 'application/zip',
};

/** Begins a film. @throws Refused */
export type BeginEncoder = (film: BeginFilm, output: FilmOutput) => Promise<FilmEncoder>;

/** Makes this worker write films by an encoder. */
export function serveFilms(encoderOf: BeginEncoder): void {
  self.onmessage = ({ data: film }: MessageEvent<BeginFilm>) =>
    serveFile(film.port, () => begun(film, encoderOf));
}

/** A film with its output. */
async function begun(film: BeginFilm, encoderOf: BeginEncoder): Promise<WrittenFile<Blob | null>> {
  const { settings, target } = film;
  const { background, format } = settings;
  const output: FilmOutput = target ? new PickedOutput(target) : new BlobOutput(TYPES[format]);
  const encoder = await encoderOf(film, output).catch(async (error: unknown) => {
    await output.abandon();
    throw error;
  });
  return {
    write: (rgba) => {
      if (background !== null) opaqueOver(background, rgba);
      return encoder.add(rgba);
    },
    finish: async () => {
      await encoder.finish();
      return output.finish();
    },
    abandon: () => {
      encoder.dispose();
      return output.abandon();
    },
  };
}
