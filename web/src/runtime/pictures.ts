/** The pictures that the state names, opened. A picture that the state no longer names is released. */
import { errorWords } from '../editor/error_words';
import type { Picture, SourceFile } from '../editor/picture';
import type { EditorState } from '../editor/state';
import { asC2WarpError, C2WarpError } from '../error';
import type { Drawn } from '../io/drawing';
import { type OpenPicture, openPicture } from '../io/open_picture';
import { readSignature } from '../io/read';
import { say } from '../texts/wording';
import { notLoaded } from './lazy_view';

export class Pictures {
  readonly #open = new Map<Picture, OpenPicture>();
  /** Pictures whose reader still has them: the state cannot name them yet. */
  readonly #reading = new Set<Picture>();

  opened(picture: Picture): OpenPicture {
    const open = this.#open.get(picture);
    if (!open) throw new Error(`${picture.name} was released`);
    return open;
  }

  /**
   * Reads a picture. It stays open until the reader passes it on or drops it.
   *
   * @throws C2WarpError whose message begins with the file's name; AbortError if the signal is aborted.
   */
  async read(file: SourceFile, name: string, signal: AbortSignal): Promise<Picture> {
    const { open, kept, lacksTexts } = await openedFile(file, name, signal);
    const { bitmap, preview } = open.texture;
    const picture: Picture = {
      id: `${performance.timeOrigin + performance.now()}`,
      name,
      // A large bitmap takes too long to scale in the page.
      thumbnail: thumbnailOf(preview ?? bitmap),
      file: kept,
      lacksTexts,
      ...open.facts,
    };
    this.#open.set(picture, open);
    this.#reading.add(picture);
    return picture;
  }

  /** Leaves a picture to the state, which names it from its next change on, or never. */
  handOver(picture: Picture): void {
    this.#reading.delete(picture);
  }

  /** Releases the pictures that neither the state nor a reader has. */
  releaseUnused({ picture, opening }: EditorState): void {
    const named = [picture, opening.trial?.before?.picture];
    this.#release((other) => !named.includes(other) && !this.#reading.has(other));
  }

  /** Releases a picture that the reader does not need. */
  drop(picture: Picture): void {
    this.#release((other) => other === picture);
  }

  dispose(): void {
    this.#release(() => true);
  }

  #release(unused: (picture: Picture) => boolean): void {
    for (const [picture, open] of this.#open) {
      if (!unused(picture)) continue;
      open.release();
      this.#open.delete(picture);
      this.#reading.delete(picture);
    }
  }
}

/** The longer side of a thumbnail: twice its size on screen, for fine displays. */
const THUMBNAIL = 96;

/** The address of a small picture; empty if this browser cannot draw one. */
function thumbnailOf(bitmap: ImageBitmap): string {
  const scale = Math.min(1, THUMBNAIL / Math.max(bitmap.width, bitmap.height));
  const [width, height] = [bitmap.width, bitmap.height].map((side) => Math.max(1, Math.round(side * scale)));
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d');
  if (!context) return '';
  context.imageSmoothingQuality = 'high';
  context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
  return canvas.toDataURL('image/webp', 0.8);
}

/** The picture of a drawing; null for any other file. The rest of the code for drawings is loaded at the first one. */
async function drawnFile(file: Blob, signal: AbortSignal): Promise<Drawn | null> {
  const { kind, name } = await readSignature(file);
  if (kind !== 'drawing' && name !== 'compressed') return null;
  const { drawnPicture } = await import('../io/drawing').catch((cause: unknown) => {
    throw notLoaded(cause);
  });
  return drawnPicture(file, async (svg, width, height) => {
    const { drawnApart } = await import('../compute/exporting').catch((cause: unknown) => {
      throw notLoaded(cause);
    });
    return drawnApart({ kind: 'picture', svg, width, height }, signal);
  });
}

/** The open picture, and the file that it is kept as: the same, but for a drawing. */
async function openedFile(
  file: SourceFile,
  name: string,
  signal: AbortSignal,
): Promise<{ readonly open: OpenPicture; readonly kept: Blob; readonly lacksTexts: boolean }> {
  try {
    const drawn = await drawnFile(file as Blob, signal);
    const kept = drawn?.file ?? (file as Blob);
    const open = await openPicture(drawn?.pixels ?? kept, signal);
    return { open, kept, lacksTexts: drawn?.lacksTexts ?? false };
  } catch (error) {
    throw withFileName(name, error);
  }
}

/** An error with the file's name before its message. An AbortError is passed on unchanged. */
export function withFileName(name: string, error: unknown): unknown {
  if (!(error instanceof Error) || error instanceof DOMException) return error;
  const wording = say('errors.inFile', name, errorWords(error));
  return new C2WarpError(asC2WarpError(error).code, `${name}: ${error.message}`, { cause: error, wording });
}
