/** Writes whole pictures to files. */
import { PictureFile } from '../../../web/src/io/encoder';

/** Returns a PNG file. @param rgba Straight alpha, transferred to the worker. */
export async function encodePng(width: number, height: number, rgba: Uint8Array<ArrayBuffer>): Promise<Blob> {
  const rest = { quality: 1, background: '#ffffff', chunks: [] };
  const file = new PictureFile({ type: 'image/png', width, height, ...rest });
  try {
    await file.write(rgba);
    return await file.finish();
  } finally {
    file.dispose();
  }
}
