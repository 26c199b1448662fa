/// <reference lib="dom" />
/** Sheets of a picture before and after an edit, side by side, drawn by the browser. */

/** The longer side of a picture on a sheet. */
const SIDE = 700;

/**
 * @param {import('@playwright/test').Page} page
 * @param {readonly Buffer[]} pictures
 * @param {number} [side]
 * @returns {Promise<Buffer>} A JPEG.
 */
export async function sheet(page, pictures, side = SIDE) {
  const address = await page.evaluate(
    async ([pictures, side]) => {
      const bitmaps = await Promise.all(
        pictures.map(async (base64) =>
          createImageBitmap(await (await fetch(`data:;base64,${base64}`)).blob()),
        ),
      );
      const scale = side / Math.max(...bitmaps.map(({ width, height }) => Math.max(width, height)));
      const [width, height] = [bitmaps[0]?.width ?? 0, bitmaps[0]?.height ?? 0].map((n) =>
        Math.round(n * scale),
      );
      const canvas = document.createElement('canvas');
      canvas.width = bitmaps.length * ((width ?? 0) + 6) - 6;
      canvas.height = height ?? 0;
      const pen = canvas.getContext('2d');
      if (!pen) return '';
      pen.fillStyle = 'white';
      pen.fillRect(0, 0, canvas.width, canvas.height);
      pen.imageSmoothingQuality = 'high';
      for (const [at, bitmap] of bitmaps.entries())
        pen.drawImage(bitmap, at * ((width ?? 0) + 6), 0, width ?? 0, height ?? 0);
      return canvas.toDataURL('image/jpeg', 0.9);
    },
    /** @type {const} */ ([pictures.map((bytes) => bytes.toString('base64')), side]),
  );
  return Buffer.from(address.slice(address.indexOf(',') + 1), 'base64');
}
