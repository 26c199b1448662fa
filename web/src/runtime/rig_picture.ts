/** The picture of a rig: the original file if players decode it, or else a PNG of the same pixels. */
import { PictureFile } from '../io/encoder';
import { plainPng } from '../io/encoding';
import type { PixelSource } from '../io/open_picture';
import { readBytes } from '../io/read';

/** The first bytes of PNG, JPEG and WebP files; undefined ones are any. */
const BEGINNINGS = [
  [0x89, 0x50, 0x4e, 0x47],
  [0xff, 0xd8, 0xff],
  [0x52, 0x49, 0x46, 0x46, undefined, undefined, undefined, undefined, 0x57, 0x45, 0x42, 0x50],
];

/** @throws The reason of the signal; Error if the pixels are gone or cannot be encoded. */
export async function rigPicture(
  file: Blob,
  source: PixelSource,
  signal: AbortSignal,
): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = new Uint8Array(await readBytes(file));
  const isKnown = BEGINNINGS.some((beginning) =>
    beginning.every((byte, at) => byte === undefined || byte === bytes[at]),
  );
  if (isKnown && (await hasSize(file, source))) return bytes;
  return encoded(source, signal);
}

/** A picture may have been scaled down when it was opened. */
async function hasSize(file: Blob, { width, height }: PixelSource): Promise<boolean> {
  try {
    const bitmap = await createImageBitmap(file);
    const fits = bitmap.width === width && bitmap.height === height;
    bitmap.close();
    return fits;
  } catch {
    return false;
  }
}

async function encoded(source: PixelSource, signal: AbortSignal): Promise<Uint8Array<ArrayBuffer>> {
  const { width, height } = source;
  const pixels = await copyOf(source);
  signal.throwIfAborted();
  const png = new PictureFile(plainPng(width, height));
  try {
    await png.write(pixels);
    return new Uint8Array(await (await png.finish()).arrayBuffer());
  } finally {
    png.dispose();
  }
}

function copyOf(source: PixelSource): Promise<Uint8Array<ArrayBuffer>> {
  const { port1, port2 } = new MessageChannel();
  return new Promise((resolve, reject) => {
    port1.onmessage = ({ data }: MessageEvent<Uint8Array<ArrayBuffer> | null>) => {
      port1.close();
      if (data) resolve(data);
      else reject(new Error('The pixels of the picture are no longer in memory. Open the picture again.'));
    };
    source.sendTo(port2);
  });
}
