/** Worker: compresses one picture to a PNG file, and is done. */
import { encode } from 'fast-png';

declare const self: DedicatedWorkerGlobalScope;

/** RGBA in straight alpha. */
interface Picture {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array;
}

self.onmessage = ({ data: { width, height, rgba } }: MessageEvent<Picture>) => {
  const bytes = encode({ width, height, data: rgba, channels: 4, depth: 8 }) as Uint8Array<ArrayBuffer>;
  self.postMessage(bytes, [bytes.buffer]);
};
