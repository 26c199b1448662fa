/**
 * Worker: reads pictures and keeps their pixels, so that the page never waits for them, nor holds them.
 *
 * Decoding a hundred million pixels takes seconds, and copying them alone takes longer than a frame.
 */
import { asC2WarpError } from '../../error';
import type { Platform } from '../decode';
import { buffersOf, luminanceOf } from '../luminance';
import type { PictureRequest, ReadReply, ReadRequest } from '../picture_messages';
import { readPicture } from '../read_picture';

declare const self: DedicatedWorkerGlobalScope;

class LackingError extends Error {}

const PLATFORM: Platform = {
  createContext() {
    // WebKitGTK and older Safaris have no WebGL here.
    const gl =
      typeof OffscreenCanvas === 'undefined'
        ? null
        : new OffscreenCanvas(1, 1).getContext('webgl2', { antialias: false, depth: false });
    if (!gl) throw new LackingError('no WebGL2');
    return gl;
  },

  imageOf: () => Promise.reject(new LackingError('no image elements')),
};

self.onmessage = ({ data: { file, port } }: MessageEvent<ReadRequest>) => void serve(file, port);

async function serve(file: Blob, port: MessagePort): Promise<void> {
  const reading = new AbortController();
  let pixels: Uint8Array<ArrayBuffer> | null = null;
  let size: { readonly width: number; readonly height: number } | null = null;
  port.onmessage = ({ data }: MessageEvent<PictureRequest>) => {
    if (data.kind === 'send') {
      sendCopy(pixels, data.to);
      return;
    }
    if (data.kind === 'luminance') {
      const values = pixels && size && luminanceOf(pixels, size.width, size.height);
      data.to.postMessage(values, values ? [...buffersOf(values)] : []);
      return;
    }
    reading.abort();
    pixels = null;
    port.close();
  };
  const reply = (message: ReadReply, transfer: Transferable[] = []) => port.postMessage(message, transfer);
  try {
    const { facts, rgba, bitmap, preview } = await readPicture(file, PLATFORM, reading.signal);
    if (reading.signal.aborted) {
      bitmap.close();
      preview?.close();
      return;
    }
    [pixels, size] = [rgba, facts];
    reply({ kind: 'read', facts, display: { bitmap, preview } }, preview ? [bitmap, preview] : [bitmap]);
  } catch (error) {
    if (!reading.signal.aborted) reply(failure(error));
  }
}

function sendCopy(pixels: Uint8Array<ArrayBuffer> | null, to: MessagePort): void {
  try {
    const copy = pixels?.slice() ?? null;
    to.postMessage(copy, copy ? [copy.buffer] : []);
  } catch {
    // The copy does not fit in memory.
    to.postMessage(null);
  }
}

function failure(error: unknown): ReadReply {
  if (error instanceof LackingError) return { kind: 'lacking' };
  const { code, message, wording } = asC2WarpError(error);
  return { kind: 'refused', code, message, wording };
}
