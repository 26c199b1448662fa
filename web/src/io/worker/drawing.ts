/** Worker: reads one drawing, which may take seconds, and draws it if a browser would take long. */
import { asC2WarpError } from '../../error';
import type { DrawingOrder, DrawingReply } from '../drawing_messages';
import { plainPng } from '../encoding';
import { readDrawing, type WritePng } from '../read_drawing';
import { PngFile } from './png_file';

declare const self: DedicatedWorkerGlobalScope;

const writePng: WritePng = async (rgba, width, height) => {
  const png = new PngFile(plainPng(width, height));
  await png.write(rgba);
  return png.finish();
};

self.onmessage = async ({ data }: MessageEvent<DrawingOrder>) => {
  const reply = (message: DrawingReply) => self.postMessage(message);
  try {
    reply({ made: await readDrawing(data, writePng) });
  } catch (error) {
    const { code, message, wording } = asC2WarpError(error);
    reply({ code, message, wording });
  }
};
