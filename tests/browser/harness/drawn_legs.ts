/** Draws a hip with two striped legs, red on the left and blue on the right, with soft edges. */
export async function drawnLegs(): Promise<Blob> {
  const canvas = new OffscreenCanvas(256, 256);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser has no 2D canvas.');
  const legs = new Path2D();
  legs.roundRect(45, 25, 166, 60, 16);
  legs.roundRect(45, 40, 60, 195, 16);
  legs.roundRect(151, 40, 60, 195, 16);
  context.clip(legs);
  for (const [x, hue] of [
    [0, 0],
    [128, 230],
  ] as const) {
    for (let y = 0; y < 256; y += 8) {
      context.fillStyle = `hsl(${hue} 70% ${40 + (y % 16)}%)`;
      context.fillRect(x, y, 128, 8);
    }
  }
  return canvas.convertToBlob();
}
