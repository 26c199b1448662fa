/** The functions that differ between browsers and Node. */
import type { Port } from '../compute/link';
import type { Pixels } from '../compute/solution';
import type { PictureInput, WarpedImage } from './types';

export interface Environment {
  /** Whether a worker solves by default. */
  readonly usesWorker: boolean;
  /** The compiled solver of this package. @throws C2WarpError with the code `engine`. */
  loadModule(): Promise<WebAssembly.Module>;
  /** The compiled later part of the solver. @throws C2WarpError with the code `engine`. */
  loadLater(): Promise<WebAssembly.Module>;
  /** The address of the worker; undefined without a worker. */
  readonly workerAddress?: string;
  /** Starts a worker with a solver. @throws C2WarpError with the code `engine`. */
  spawn(): Port;
  /** Decodes a file. @throws C2WarpError with the code `picture`. */
  decode(bytes: Uint8Array<ArrayBuffer>, signal: AbortSignal): Promise<Pixels>;
  /** The pixels of a bitmap or a canvas; undefined for any other object. */
  drawn(input: Exclude<PictureInput, ArrayBuffer>): Pixels | undefined;
  image(pixels: Pixels): WarpedImage;
}
