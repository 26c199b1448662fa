/** Types of the arguments and attributes of `<c2-warp>`. */
import type { Handle, HandleFile } from '../document/project';
import type { PictureType } from '../io/encoding';

/** A handle whose id is optional: the editor generates a missing one. */
export type NewHandle<H = HandleFile> = H extends HandleFile
  ? Omit<H, 'id'> & { readonly id?: string }
  : never;

/**
 * The pose of the handle with this id. Keys that are left out stay; `kind` and `rest` cannot change.
 */
export type HandlePose = Pick<Handle, 'id'> & Partial<Handle>;

export interface LoadOptions {
  /** A notice of the editor names a failure. By default only the page hears of it. */
  readonly notice?: boolean;
  /** Gives the picture up: the promise rejects with the reason of the signal, and the picture before stays open. */
  readonly signal?: AbortSignal | undefined;
}

/** A picture for `load()`: an address, a file, or pixels. Pixels of a canvas or a bitmap are kept as a PNG. */
export type PictureSource =
  | string
  | URL
  | Blob
  | HTMLImageElement
  | HTMLCanvasElement
  | OffscreenCanvas
  | ImageBitmap
  | ImageData;

/** How a warped picture is drawn. */
export interface WarpOptions {
  /** Pixels per pixel of the original. By default 1. */
  readonly scale?: number | undefined;
  /** Enlarges the result to hold the parts that are bent beyond the picture. */
  readonly grow?: boolean;
  /** Crops the result to all that is drawn, parts bent beyond the picture included. Replaces `grow`. */
  readonly crop?: boolean;
  /** For pixel art: no colours are mixed. By default as the picture is shown. */
  readonly pixelated?: boolean | undefined;
  /** Stops the work: the promise rejects with the reason of the signal. */
  readonly signal?: AbortSignal | undefined;
}

/** How a warped picture is written to a file. */
export interface BlobOptions extends WarpOptions {
  /** By default `image/png`. */
  readonly type?: PictureType;
  /** Of a JPEG or WebP, from 0 to 1. By default 0.9. */
  readonly quality?: number;
  /** The colour below translucent pixels of a JPEG, as `#rrggbb`. By default white. */
  readonly background?: string;
  /** Called with the fraction that is done, from 0 to 1. */
  readonly onProgress?: ((fraction: number) => void) | undefined;
}
