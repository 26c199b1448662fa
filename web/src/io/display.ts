/**
 * Copies of a picture for the screen: bounded in size, because exports use the original pixels.
 *
 * A large picture takes many frames to reach the graphics card. A preview shows it meanwhile.
 */

export interface Display {
  /** Premultiplied. Smaller than the picture if that exceeds the largest texture or the memory limit. */
  readonly bitmap: ImageBitmap;
  /** Null for a picture that is uploaded at once. */
  readonly preview: ImageBitmap | null;
}

/** With its mip levels, a texture of so many pixels takes 256 MB. It holds photographs of phones whole. */
const MAX_PIXELS = 48e6;
/** Pictures up to this size need no preview. */
const MAX_AT_ONCE = 4e6;
const PREVIEW_SIDE = 1024;

/** Returns the copies of a premultiplied bitmap, which is closed unless it is one of them. */
export async function displayOf(picture: ImageBitmap, largestTexture: number): Promise<Display> {
  const { width, height } = picture;
  const most = Math.sqrt(MAX_PIXELS / (width * height));
  const bitmap = await shrunk(picture, Math.min(1, most, largestTexture / Math.max(width, height)));
  if (bitmap !== picture) picture.close();
  const isLarge = bitmap.width * bitmap.height > MAX_AT_ONCE;
  const preview = isLarge ? await shrunk(bitmap, PREVIEW_SIDE / Math.max(bitmap.width, bitmap.height)) : null;
  return { bitmap, preview };
}

async function shrunk(picture: ImageBitmap, ratio: number): Promise<ImageBitmap> {
  if (ratio >= 1) return picture;
  return createImageBitmap(picture, {
    resizeWidth: Math.max(1, Math.floor(picture.width * ratio)),
    resizeHeight: Math.max(1, Math.floor(picture.height * ratio)),
    resizeQuality: 'high',
  });
}
