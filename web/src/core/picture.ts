/** The pixels of a picture from the caller. */
import type { Pixels } from '../compute/solution';
import { C2WarpError } from '../error';
import { checkSize } from '../io/limits';
import type { Environment } from './environment';
import type { PictureInput, PixelData, WarperOptions } from './types';

const UNKNOWN =
  'This is not a picture. Pass the bytes of a file, or pixels as { width, height, data } with four bytes per pixel.';

/**
 * Returns a copy of the pixels.
 *
 * @throws C2WarpError with the code `picture` for anything but a picture of a supported size.
 * @throws the reason of the signal if that is aborted.
 */
export async function pixelsOf(
  input: PictureInput,
  environment: Environment,
  { decode, signal = new AbortController().signal }: WarperOptions,
): Promise<Pixels> {
  signal.throwIfAborted();
  const bytes = await bytesOf(input);
  if (bytes) {
    if (!decode) return environment.decode(bytes, signal);
    const decoded = await decode(bytes);
    signal.throwIfAborted();
    return copied(decoded);
  }
  if (typeof input !== 'object' || input === null) throw new C2WarpError('picture', UNKNOWN);
  if ('data' in input) return copied(input);
  const drawn = environment.drawn(input as Exclude<PictureInput, ArrayBuffer>);
  if (!drawn) throw new C2WarpError('picture', UNKNOWN);
  return drawn;
}

/** A copy of the bytes of a file; undefined for pixels. */
async function bytesOf(input: PictureInput): Promise<Uint8Array<ArrayBuffer> | undefined> {
  if (input instanceof ArrayBuffer) return new Uint8Array(input.slice(0));
  if (ArrayBuffer.isView(input)) {
    return new Uint8Array(
      input.buffer,
      input.byteOffset,
      input.byteLength,
    ).slice() as Uint8Array<ArrayBuffer>;
  }
  if (typeof Blob !== 'undefined' && input instanceof Blob) return new Uint8Array(await input.arrayBuffer());
  return undefined;
}

function copied({ width, height, data }: PixelData): Pixels {
  checkSize(width, height);
  if (!ArrayBuffer.isView(data) || data.BYTES_PER_ELEMENT !== 1) throw new C2WarpError('picture', UNKNOWN);
  const bytes = width * height * 4;
  if (data.length !== bytes) {
    const message = `Expected ${bytes} bytes for ${width} × ${height} pixels in RGBA, found ${data.length}.`;
    throw new C2WarpError('picture', message);
  }
  return { width, height, rgba: Uint8Array.from(data) };
}
