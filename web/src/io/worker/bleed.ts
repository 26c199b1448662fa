/**
 * Continues the colours of a picture into its transparent parts.
 *
 * Video keeps colours and transparency apart, and both lossily. Black behind a soft edge would darken it.
 */

/** Pixels that an edge can be smeared by: half the largest block that codecs predict. */
const REACH = 32;

/** Gives transparent pixels of straight RGBA the colour of the nearest other ones in their row or column. */
export function bleed(rgba: Uint8Array, width: number, height: number): void {
  const pixels = new Uint32Array(rgba.buffer, rgba.byteOffset, width * height);
  for (let y = 0; y < height; y++) {
    along(pixels, y * width, 1, width);
    along(pixels, (y + 1) * width - 1, -1, width);
  }
  for (let x = 0; x < width; x++) {
    along(pixels, x, width, height);
    along(pixels, (height - 1) * width + x, -width, height);
  }
}

/** The low bytes are the colours: all machines that run browsers begin with the lowest byte. */
const COLOURS = 0x00ffffff;

function along(pixels: Uint32Array, start: number, step: number, count: number): void {
  let colour = 0;
  let left = 0;
  for (let at = start, k = 0; k < count; at += step, k++) {
    const pixel = pixels[at] as number;
    if (pixel > COLOURS) {
      colour = pixel & COLOURS;
      left = REACH;
    } else if (pixel !== 0) {
      // Coloured by another pass.
      left = 0;
    } else if (left > 0) {
      pixels[at] = colour;
      left -= 1;
    }
  }
}
