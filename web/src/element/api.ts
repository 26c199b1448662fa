/** Types of the arguments and attributes of `<c2-warp>`. */
import type { Handle, HandleFile } from '../document/project';
import type { PictureType } from '../io/encoding';

/** A handle whose id is optional: the editor generates a missing one. */
export type NewHandle<H = HandleFile> = H extends HandleFile
  ? Omit<H, 'id'> & { readonly id?: string }
  : never;

/**
 * The pose of the handle with this id. Missing keys do not change; `kind` and `rest` cannot be changed.
 */
export type HandlePose = Pick<Handle, 'id'> & Partial<Handle>;

export interface LoadOptions {
  /** The editor shows failures in a notice. By default, only the page receives them. */
  readonly notice?: boolean;
  /** Cancels loading: the promise rejects with the reason of the signal, and the previous picture remains open. */
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
  /** Pixels of the result per pixel of the original. By default 1. */
  readonly scale?: number | undefined;
  /** Enlarges the result to contain parts that are bent beyond the picture. */
  readonly grow?: boolean;
  /** Crops the result to everything that is drawn, including parts bent beyond the picture. Replaces `grow`. */
  readonly crop?: boolean;
  /** For pixel art: mixes no colours. By default, as the picture is shown. */
  readonly pixelated?: boolean | undefined;
  /** Cancels the work: the promise rejects with the reason of the signal. */
  readonly signal?: AbortSignal | undefined;
}

/** How a warped picture is written to a file. */
export interface BlobOptions extends WarpOptions {
  /** Default: `image/png`. */
  readonly type?: PictureType;
  /** Quality of a JPEG or WebP, from 0 to 1. By default 0.9. */
  readonly quality?: number;
  /** The colour below translucent pixels of a JPEG, as `#rrggbb`. Default: white. */
  readonly background?: string;
  /** Called with the completed fraction, from 0 to 1. */
  readonly onProgress?: ((fraction: number) => void) | undefined;
}
