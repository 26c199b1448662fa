/** The messages between the page and the worker that writes picture files. */

export type PictureType = 'image/png' | 'image/jpeg' | 'image/webp';

/** An additional chunk of a PNG file, written before the pixels. */
export interface PngChunk {
  /** Four letters, such as `iTXt`. Lower case of the first and last says: not critical, safe to copy. */
  readonly type: string;
  readonly data: Uint8Array<ArrayBuffer>;
}

/** A file to be written. */
export interface FileSettings {
  readonly type: PictureType;
  readonly width: number;
  readonly height: number;
  /** For JPEG and WebP, from 0 to 1. */
  readonly quality: number;
  /** The colour below translucent pixels of a JPEG, as `#rrggbb`. */
  readonly background: string;
  /** For PNG. */
  readonly chunks: readonly PngChunk[];
}

/** To the worker itself: begins a file. Everything about this file goes through the port. */
export interface BeginFile {
  readonly settings: FileSettings;
  readonly port: MessagePort;
}

/** A PNG of all pixels, without further chunks. */
export const plainPng = (width: number, height: number): FileSettings => ({
  type: 'image/png',
  width,
  height,
  quality: 1,
  background: '#ffffff',
  chunks: [],
});
