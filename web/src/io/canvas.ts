/** Pictures on a canvas of the page. Canvases premultiply, so translucent colours are rounded. */

/**
 * Puts rows on a canvas.
 *
 * @param rgba Straight alpha.
 * @throws Error if the browser cannot draw on a canvas of this size.
 */
export function putRows(canvas: HTMLCanvasElement, top: number, rgba: Uint8Array<ArrayBuffer>): void {
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser cannot draw on a 2D canvas.');
  const bytes = new Uint8ClampedArray(rgba.buffer, rgba.byteOffset, rgba.length);
  context.putImageData(new ImageData(bytes, canvas.width), 0, top);
}
