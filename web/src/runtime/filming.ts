/**
 * Draws the frames of a clip one after another, while a worker encodes the frame before. Loaded at first use.
 *
 * Three frames exist at a time: one is drawn, one waits, and one is encoded. So memory does not grow with the film.
 */
import type { Filming } from '../compute/filming';
import type { EditorEffect } from '../editor/effects';
import type { VideoCodecs } from '../editor/film_choices';
import { type FilmKind, pickTarget, removeEmpty, saveFile } from '../io/files';
import { FilmFile } from '../io/film_file';
import type { FilmFormat } from '../io/filming';
import { type CodecChoice, findCodec, type VideoShape } from '../io/video_codecs';
import { unlessAborted } from './exporting';
import type { ExportFollowing } from './exports';
import type { Solver } from './solver';

const KINDS: Readonly<Record<FilmFormat, FilmKind>> = {
  webm: 'webm',
  mp4: 'mp4',
  gif: 'gif',
  apng: 'png',
  webp: 'webp',
  frames: 'zip',
  sheet: 'zip',
};

type Order = Extract<EditorEffect, { readonly type: 'export-film' }>;

/**
 * Asks for a file, and writes a film to it. Returns its name, or null if the person cancels.
 *
 * @throws The reason of the signal; Error that names what failed.
 */
export async function exportedFilm(
  solver: Solver,
  { name, project, clip, film }: Order,
  pixelated: boolean,
  following: ExportFollowing,
): Promise<string | null> {
  const { format, rate, range, scale, area } = film;
  const kind = KINDS[format];
  // First of all: browsers ask only shortly after a click.
  const target = await pickTarget(name, kind);
  if (target === 'cancelled') return null;
  let filming: Filming | null = null;
  try {
    const asked = solver.film(project, clip, { rate, range, scale, pixelated });
    filming = await opened(asked, following.signal);
    const blob = await written(
      filming,
      film,
      target,
      area === 'grown' ? await grown(filming, following) : following,
    );
    return blob ? await saveFile(blob, name, kind) : (target?.name ?? name);
  } catch (error) {
    // Before a film has begun, nothing else removes the file.
    if (!filming) await removeEmpty(target);
    throw error;
  } finally {
    filming?.release();
  }
}

/** A film that comes too late is released. */
function opened(asked: Promise<Filming>, signal: AbortSignal): Promise<Filming> {
  asked.then(
    (filming) => signal.aborted && filming.release(),
    () => {},
  );
  return unlessAborted(asked, signal);
}

async function written(
  filming: Filming,
  film: Order['film'],
  target: FileSystemFileHandle | null,
  { signal, onProgress }: ExportFollowing,
): Promise<Blob | null> {
  const { width, height, frames, endlessly } = filming.size;
  const { format, rate, background, matte, bits, name } = film;
  const shape = { width, height, rate };
  const codec = format === 'webm' || format === 'mp4' ? await findCodec(format, shape) : null;
  const settings = { format, ...shape, frames, endlessly, background, matte, bits, codec, name };
  const picture = format === 'gif' ? await restPicture(filming, signal) : null;
  const file = new FilmFile(settings, picture, target);
  const began = performance.now();
  try {
    let adding: Promise<void> = Promise.resolve();
    for (let frame = 0; frame < frames; frame++) {
      const drawing = await unlessAborted(filming.frame(frame), signal);
      const { rgba } = await unlessAborted(drawing.pixels(), signal);
      await unlessAborted(adding, signal);
      adding = file.write(rgba);
      // Awaited with the next frame.
      adding.catch(() => {});
      const seconds = (performance.now() - began) / 1000;
      onProgress((frame + 1) / (frames + 1), secondsLeft(seconds, frame + 1, frames));
    }
    await unlessAborted(adding, signal);
    return await unlessAborted(file.finish(), signal);
  } finally {
    // Not awaited: a frame that is being encoded ends first. A complete file is not empty, and stays.
    file.dispose().then(() => removeEmpty(target));
  }
}

/** The part of the time that it takes to find the rectangle of all frames. */
const GROWN = 0.1;

/** Grows the frames to hold all that is drawn in any. Returns how to follow the rest. */
async function grown(filming: Filming, following: ExportFollowing): Promise<ExportFollowing> {
  const { signal, onProgress } = following;
  const { frames } = filming.size;
  for (let frame = 0; frame < frames; frame++) {
    await unlessAborted(filming.include(frame), signal);
    onProgress((GROWN * (frame + 1)) / frames);
  }
  return {
    ...following,
    onProgress: (fraction, left) => onProgress(GROWN + (1 - GROWN) * fraction, left),
  };
}

async function restPicture(filming: Filming, signal: AbortSignal): Promise<Uint8Array<ArrayBuffer>> {
  const drawing = await unlessAborted(filming.atRest(), signal);
  return (await unlessAborted(drawing.pixels(), signal)).rgba;
}

/** Seconds after which the pace is known. */
const KNOWN_AFTER = 1;

const secondsLeft = (seconds: number, done: number, all: number): number | undefined =>
  seconds < KNOWN_AFTER ? undefined : (seconds / done) * (all - done);

/** This browser's codecs for films of a shape. */
export async function videoCodecs(shape: VideoShape): Promise<VideoCodecs> {
  const [webm, mp4] = await Promise.all([findCodec('webm', shape), findCodec('mp4', shape)]);
  return { webm: codecInfo(webm), mp4: codecInfo(mp4) };
}

const codecInfo = (choice: CodecChoice | null) =>
  choice && { codec: choice.codec, width: choice.width, height: choice.height };
