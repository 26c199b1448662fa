/** The messages between the page and the worker that reads a drawing. */
import type { C2WarpErrorCode } from '../error';
import type { Wording } from '../texts/wording';

export interface DrawingRequest {
  /** `picture` wants pixels, `plain` the form that can be bent. */
  readonly kind: keyof DrawingReplies;
  /** A drawing, or a compressed file. */
  readonly file: Blob;
}

/** The only message to the worker. */
export interface DrawingOrder {
  readonly request: DrawingRequest;
  /** The address of the WebAssembly module. */
  readonly module: string;
}

/** A drawing that was read for its picture. */
export interface ReadPicture {
  /** The drawing in UTF-8, as it is kept. */
  readonly file: Blob;
  /** A PNG; null if the browser shall draw `sized`, which takes it no time. */
  readonly pixels: Blob | null;
  /** The drawing with this size in pixels. */
  readonly sized: Blob;
  readonly width: number;
  readonly height: number;
  /** Whether texts of the drawing are missing in the pixels. */
  readonly lacksTexts: boolean;
}

/** A drawing that can be bent: SVG with shapes as paths, in units of its own. */
export interface PlainDrawing {
  readonly svg: string;
  readonly width: number;
  readonly height: number;
  /** Parts that are left out or do not bend, in English. */
  readonly remarks: readonly string[];
}

/** The results by the kinds of requests; null for a compressed file that is no drawing. */
export interface DrawingReplies {
  readonly picture: ReadPicture | null;
  readonly plain: PlainDrawing | null;
}

export type DrawingReply =
  | { readonly made: DrawingReplies[keyof DrawingReplies] }
  | { readonly code: C2WarpErrorCode; readonly message: string; readonly wording: Wording | undefined };
