/** Worker: compresses pictures to PNG files. */
import { encode } from 'fast-png';

declare const self: DedicatedWorkerGlobalScope;

/** RGBA in straight alpha. */
interface Picture {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array;
  /** Receives the file's bytes. */
  readonly to: MessagePort;
}

self.onmessage = ({ data: { width, height, rgba, to } }: MessageEvent<Picture>) => {
  const bytes = encode({ width, height, data: rgba, channels: 4, depth: 8 }) as Uint8Array<ArrayBuffer>;
  to.postMessage(bytes, [bytes.buffer]);
};
