/** The pixels of the pictures that the state names. A picture that the state no longer names is released. */
import type { Picture, SourceFile } from '../editor/picture';
import type { EditorState } from '../editor/state';
import { codeOf, WarpError } from '../error';
import { alphaThreshold } from '../io/alpha';
import { type DecodedPicture, decodePicture } from '../io/decode';
import { isPixelArt, isSmall } from '../io/pixel_art';

export class Pictures {
  readonly #decoded = new Map<Picture, DecodedPicture>();

  pixelsOf(picture: Picture): DecodedPicture {
    const decoded = this.#decoded.get(picture);
    if (!decoded) throw new Error(`the pixels of ${picture.name} were released`);
    return decoded;
  }

  /** @throws WarpError whose message begins with the file's name. */
  async read(file: SourceFile, name: string): Promise<Picture> {
    const decoded = await decodedOf(file, name);
    const { width, height, moves } = decoded;
    const picture: Picture = {
      id: `${performance.timeOrigin + performance.now()}`,
      name,
      thumbnail: thumbnailOf(decoded.bitmap),
      file,
      width,
      height,
      alphaThreshold: alphaThreshold(decoded),
      isSmall: isSmall(decoded),
      isPixelArt: isPixelArt(decoded),
      moves,
    };
    this.#decoded.set(picture, decoded);
    return picture;
  }

  /** Releases the pictures that the state does not name. */
  releaseUnused({ picture, opening }: EditorState): void {
    this.#release((other) => other !== picture && other !== opening.trial?.before?.picture);
  }

  /** Releases one picture that never came into the state. */
  drop(picture: Picture): void {
    this.#release((other) => other === picture);
  }

  dispose(): void {
    this.#release(() => true);
  }

  #release(unused: (picture: Picture) => boolean): void {
    for (const [picture, { bitmap }] of this.#decoded) {
      if (!unused(picture)) continue;
      bitmap.close();
      this.#decoded.delete(picture);
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

async function decodedOf(file: SourceFile, name: string): Promise<DecodedPicture> {
  try {
    return await decodePicture(file as Blob);
  } catch (error) {
    throw withFileName(name, error);
  }
}

/** An error with the file's name before its message. Errors without a code, such as an AbortError, stay as they are. */
export function withFileName(name: string, error: unknown): unknown {
  if (!(error instanceof Error) || error instanceof DOMException) return error;
  return new WarpError(codeOf(error), `${name}: ${error.message}`, { cause: error });
}
