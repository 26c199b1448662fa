/** A drawing as pixels. */
import type { DrawnPicture, PictureOrder } from '../../exporting_messages';
import { drawnPicture as drawn } from '../../generated/c2warp_export';

/** @throws Error for a drawing that cannot be read, or takes too long to draw. */
export function drawnPicture({ svg, width, height }: PictureOrder): DrawnPicture {
  const { png, lacksTexts } = drawn(svg, width, height);
  return { png: (png as Uint8Array<ArrayBuffer> | undefined) ?? null, lacksTexts };
}
