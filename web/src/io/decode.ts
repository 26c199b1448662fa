/**
 * Decodes pictures with the browser's decoders, which apply the EXIF orientation and convert colour profiles to sRGB.
 * A picture with neither keeps its exact bytes.
 *
 * Files on which browsers disagree are changed first. `web/docs/pictures.md` lists them.
 *
 * It runs in a worker, or in the page if the worker lacks something: see {@link Platform}.
 */

import type { C2WarpError } from '../error';
import { say } from '../texts/wording';
import { type Header, readHeader } from './formats/header';
import { probes } from './formats/jpeg';
import { withoutExif } from './formats/webp';
import { checkSize } from './limits';
import { pictureError } from './picture_error';
import { type CreateContext, type DecodedImage, straightPixels } from './pixels';
import { readBytes } from './read';
import { turned } from './turn';

/** The parts of a page that a worker may lack. */
export interface Platform {
  readonly createContext: CreateContext;
  /** Decodes a file with an image element. Resolves to null if the browser or the page's policy refuses it. */
  imageOf(file: Blob): Promise<DecodedImage | null>;
}

export interface DecodedPicture {
  /** Premultiplied, for drawing. The caller closes it. */
  readonly bitmap: ImageBitmap;
  readonly width: number;
  readonly height: number;
  /** Straight alpha: RGBA, rows from the top. */
  readonly rgba: Uint8Array<ArrayBuffer>;
  /** Whether the file has several frames. The picture is the first. */
  readonly moves: boolean;
}

/**
 * Returns the picture in a file.
 *
 * @throws C2WarpError if the file is not a picture, is incomplete, or has an unsupported size.
 * @throws ReadError if the bytes cannot be read.
 * @throws AbortError if the signal is aborted.
 */
export async function decodePicture(
  file: Blob,
  platform: Platform,
  signal: AbortSignal,
): Promise<DecodedPicture> {
  if (file.size === 0) throw pictureError('picture', say('errors.picture.empty'));
  const bytes = await readBytes(file);
  const header = readHeader(bytes);
  const { kind, size, end, moves, orientation = 1 } = header;
  if (kind === 'drawing') throw unreadable(header);
  // Checked before decoding: a small file can hold more pixels than fit in memory.
  if (size) checkSize(size.width, size.height);
  if (end === 'missing') throw pictureError('picture', say('errors.picture.incomplete'));
  const decoder = new Decoder(header, platform, signal);
  if (typeof end === 'number') return { ...(await decoder.decodeUnmarked(probes(bytes, end))), moves };
  if (orientation === 1) return { ...(await decoder.decode(file)), moves };

  const { bitmap, ...stored } = await decoder.decode(new Blob([withoutExif(bytes)], { type: file.type }));
  bitmap.close();
  const { width, height, rgba } = turned(stored, orientation);
  const data = new ImageData(new Uint8ClampedArray(rgba.buffer), width, height);
  return { width, height, rgba, moves, bitmap: await createImageBitmap(data) };
}

type Decoded = Omit<DecodedPicture, 'moves'>;

function isSame(a: Uint8Array<ArrayBuffer>, b: Uint8Array<ArrayBuffer>): boolean {
  const [colours, others] = [new Uint32Array(a.buffer), new Uint32Array(b.buffer)];
  return colours.length === others.length && colours.every((colour, i) => colour === others[i]);
}

/** The error for a file that the browser cannot decode. */
function unreadable({ kind, name }: Header, cause?: unknown): C2WarpError {
  const isOther = kind === 'other' || kind === 'drawing';
  const wording =
    name === undefined
      ? say('errors.picture.unknown')
      : isOther
        ? say('errors.picture.otherKind', say(`errors.picture.kinds.${name}`))
        : say('errors.picture.damaged');
  return pictureError('picture', wording, { cause });
}

/** Set by the first picture that can have transparency. */
let bitmapsKeepColours: boolean | undefined;

/** Decodes files of one kind. */
class Decoder {
  readonly #header: Header;
  readonly #platform: Platform;
  readonly #signal: AbortSignal;

  constructor(header: Header, platform: Platform, signal: AbortSignal) {
    this.#header = header;
    this.#platform = platform;
    this.#signal = signal;
  }

  async decode(file: Blob): Promise<Decoded> {
    const isJpeg = this.#header.kind === 'jpeg';
    const straight = await this.#bitmapOf(file, 'none');
    let bitmap: ImageBitmap | undefined;
    try {
      checkSize(straight.width, straight.height);
      this.#signal.throwIfAborted();
      const image = isJpeg || (await this.#keepsColours()) ? null : await this.#platform.imageOf(file);
      const { createContext } = this.#platform;
      const rgba = straightPixels(image ?? straight, straight.width, straight.height, createContext);
      this.#signal.throwIfAborted();
      // The caller closes this bitmap, so nothing may fail after this line. A JPEG has no alpha: decode it once.
      bitmap = isJpeg ? straight : await this.#bitmapOf(file, 'premultiply');
      return { bitmap, width: bitmap.width, height: bitmap.height, rgba };
    } finally {
      if (bitmap !== straight) straight.close();
    }
  }

  /** Decodes a JPEG without an end marker, given by its probes. */
  async decodeUnmarked([plain, ...filled]: readonly Blob[]): Promise<Decoded> {
    const picture = await this.decode(plain ?? new Blob());
    for (const probe of filled) {
      const other = await this.decode(probe).catch(() => null);
      other?.bitmap.close();
      if (other && isSame(picture.rgba, other.rgba)) continue;
      picture.bitmap.close();
      this.#signal.throwIfAborted();
      throw pictureError('picture', say('errors.picture.incomplete'));
    }
    return picture;
  }

  async #bitmapOf(file: Blob, premultiplyAlpha: 'none' | 'premultiply'): Promise<ImageBitmap> {
    try {
      return await createImageBitmap(file, { premultiplyAlpha });
    } catch (cause) {
      // Firefox fails here for some photographs with EXIF data, but decodes them in an image element.
      const image = this.#header.kind === 'jpeg' ? await this.#platform.imageOf(file) : null;
      const bitmap = image && (await createImageBitmap(image, { premultiplyAlpha }).catch(() => null));
      if (bitmap) return bitmap;
      throw unreadable(this.#header, cause);
    }
  }

  /**
   * Whether bitmaps keep the exact colours of translucent pixels. WebKit premultiplies them and divides again; its
   * image elements keep the colours.
   */
  async #keepsColours(): Promise<boolean> {
    bitmapsKeepColours ??= await probeBitmapColours(this.#platform.createContext);
    return bitmapsKeepColours;
  }
}

async function probeBitmapColours(createContext: CreateContext): Promise<boolean> {
  const colour = Uint8ClampedArray.of(200, 100, 50, 1);
  const bitmap = await createImageBitmap(new ImageData(colour, 1, 1), { premultiplyAlpha: 'none' });
  try {
    return straightPixels(bitmap, 1, 1, createContext).every((value, i) => value === colour[i]);
  } finally {
    bitmap.close();
  }
}
