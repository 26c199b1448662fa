/** Draws two discs that a thin gap parts, with a soft glow around them and a spark in it. */
export async function drawnGlow(): Promise<Blob> {
  const canvas = new OffscreenCanvas(256, 256);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser has no 2D canvas.');
  for (const x of [90, 166]) {
    const glow = context.createRadialGradient(x, 128, 36, x, 128, 84);
    glow.addColorStop(0, 'rgb(40 200 255 / 70%)');
    glow.addColorStop(1, 'rgb(40 200 255 / 0%)');
    context.fillStyle = glow;
    context.fillRect(0, 0, 256, 256);
  }
  context.fillStyle = 'rgb(240 180 40)';
  for (const x of [90, 166]) {
    context.beginPath();
    context.arc(x, 128, 37, 0, 2 * Math.PI);
    context.fill();
  }
  context.fillRect(126, 20, 2, 2);
  return canvas.convertToBlob();
}
