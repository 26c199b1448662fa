/** A fill as a part of the picture that the renderer draws. */
import type { FillData } from '../compute/solution';
import type { TexturePatch } from '../render/picture';

/** The bitmap of a fill. Its owner closes it. */
export async function fillPatch({ box: [left, top, width, height], rgba }: FillData): Promise<TexturePatch> {
  const image = new ImageData(new Uint8ClampedArray(rgba.buffer), width, height);
  const bitmap = await createImageBitmap(image, {
    premultiplyAlpha: 'premultiply',
    colorSpaceConversion: 'none',
  });
  return { left, top, bitmap };
}
