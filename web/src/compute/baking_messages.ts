/** The messages between the page and the worker that bakes a rig. */

/** The only message to the worker. */
export interface BakeRequest {
  /** Compiled by the page. */
  readonly module: WebAssembly.Module;
  /** JSON text. */
  readonly project: string;
  readonly width: number;
  readonly height: number;
  /** The pixels arrive here, or null if the picture was released. */
  readonly pixels: MessagePort;
  /** A PNG, WebP or JPEG file of the picture. */
  readonly file: Uint8Array<ArrayBuffer>;
}

export type BakeReply =
  /** The part that is done, from 0 to 1. */
  | { readonly part: number }
  | { readonly rig: Uint8Array<ArrayBuffer> }
  /** A sentence for people, or null if the module broke. */
  | { readonly refused: string | null };
