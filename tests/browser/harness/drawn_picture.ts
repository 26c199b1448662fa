/** Draws a test picture: two islands, one with holes, soft edges, and a colour gradient. */
export async function drawnPicture(size = 256): Promise<Blob> {
  const canvas = new OffscreenCanvas(size, size);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser has no 2D canvas.');
  context.scale(size / 256, size / 256);
  const gradient = context.createLinearGradient(0, 0, 256, 256);
  for (let stop = 0; stop <= 8; stop++) gradient.addColorStop(stop / 8, `hsl(${stop * 45} 70% 55%)`);
  context.fillStyle = gradient;
  context.beginPath();
  context.roundRect(20, 30, 150, 190, 24);
  context.moveTo(126, 90);
  context.arc(95, 90, 30, 0, 2 * Math.PI, true);
  context.moveTo(120, 170);
  context.arc(95, 170, 24, 0, 2 * Math.PI, true);
  context.moveTo(236, 128);
  context.arc(208, 128, 28, 0, 2 * Math.PI);
  context.fill('evenodd');
  return canvas.convertToBlob();
}
