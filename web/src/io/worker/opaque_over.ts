import { colourOf } from './colours';

/** Draws straight RGBA over a colour, in place. @param background as `#rrggbb`. */
export function opaqueOver(background: string, rgba: Uint8Array): void {
  const below = colourOf(background);
  for (let at = 0; at < rgba.length; at += 4) {
    const alpha = rgba[at + 3] ?? 0;
    if (alpha === 255) continue;
    for (let channel = 0; channel < 3; channel++) {
      const [above, under] = [rgba[at + channel] ?? 0, below[channel] ?? 0];
      rgba[at + channel] = Math.round((above * alpha + under * (255 - alpha)) / 255);
    }
    rgba[at + 3] = 255;
  }
}
