/** Files of warped pictures. */
import type { PixelData } from './types';

/** The bytes of a PNG file with exactly these pixels. A canvas would round translucent colours. */
export async function encodePng(image: PixelData): Promise<Uint8Array<ArrayBuffer>> {
  // Many programs write no files.
  return (await import('./png_bytes')).pngBytes(image);
}
