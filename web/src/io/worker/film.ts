/** Worker: writes films from frames. The parts of a format are loaded when it is first used. */
import type { BeginFilm, FilmReply, FilmRequest, FilmSettings } from '../filming';
import type { FilmEncoder } from './film_encoder';
import { BlobOutput, type FilmOutput, PickedOutput, StorageRefused } from './film_output';
import { opaqueOver } from './opaque_over';
import { Broken, Refused } from './refused';

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

async function begun({ settings, picture }: BeginFilm, output: FilmOutput): Promise<FilmEncoder> {
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

self.onmessage = ({ data: film }: MessageEvent<BeginFilm>) => {
  const { settings, target, port } = film;
  const output: FilmOutput = target ? new PickedOutput(target) : new BlobOutput(TYPES[settings.format]);
  let encoder: FilmEncoder | null = null;
  let finished = false;
  /** Answers all requests after a refusal. */
  let refused: Refused | null = null;

  async function handle(request: FilmRequest): Promise<void> {
    if (request === 'abandon') {
      encoder?.dispose();
      if (!finished) await output.abandon();
      port.postMessage('gone' satisfies FilmReply);
      return;
    }
    let answered = false;
    const reply = (message: FilmReply) => {
      answered = true;
      port.postMessage(message);
    };
    try {
      if (refused) throw refused;
      encoder ??= await begun(film, output);
      if (request === 'end') {
        await encoder.finish();
        const film = await output.finish();
        finished = true;
        reply({ film });
        return;
      }
      // The page sends the next frame while this one is written.
      reply('taken');
      const { rgba } = request;
      if (settings.background !== null) opaqueOver(settings.background, rgba);
      await encoder.add(rgba);
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      refused = error;
      const fault = error instanceof StorageRefused ? 'storage' : 'encoder';
      if (!answered) reply({ refused: error.message, fault });
      if (error instanceof Broken) throw error;
    }
  }

  let writing: Promise<void> = Promise.resolve();
  port.onmessage = ({ data }: MessageEvent<FilmRequest>) => {
    writing = writing
      .then(() => handle(data))
      .catch((error: unknown) => {
        // A fault: the page hears of it as an error of this worker, and replaces it.
        port.close();
        reportError(error);
      });
  };
};
