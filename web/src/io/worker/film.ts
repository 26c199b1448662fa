/** Worker: writes films from frames. The parts of a format are loaded when it is first used. */
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

self.onmessage = ({ data: film }: MessageEvent<BeginFilm>) => serveFile(film.port, () => begun(film));

/** A film with its output. */
async function begun(film: BeginFilm): Promise<WrittenFile<Blob | null>> {
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

async function encoderOf({ settings, picture }: BeginFilm, output: FilmOutput): Promise<FilmEncoder> {
  const { format, background } = settings;
  if (format === 'webm' || format === 'mp4') {
    const { VideoFilm } = await import('./video_film');
    return VideoFilm.begin(settings, format, output);
  }
  if (format === 'frames' || format === 'sheet') {
    const { FramesFilm, SheetFilm } = await import('./zipped_film');
    return format === 'frames' ? new FramesFilm(settings, output) : SheetFilm.begin(settings, output);
  }
  const { ModuleFilm } = await import('./module_film');
  if (picture && background !== null) opaqueOver(background, picture);
  return ModuleFilm.begin(settings, format, picture, (position, bytes) => output.write(position, bytes));
}
