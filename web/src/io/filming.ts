/** The messages between the page and the worker that writes films. */
import type { CodecChoice, VideoFormat } from './video_codecs';

/** `frames`: a zip of PNG files. `sheet`: a zip of a sprite sheet and its JSON. */
export type FilmFormat = VideoFormat | 'gif' | 'apng' | 'webp' | 'frames' | 'sheet';

/** A film to be written. */
export interface FilmSettings {
  readonly format: FilmFormat;
  /** Of the frames. */
  readonly width: number;
  readonly height: number;
  readonly frames: number;
  /** Frames a second. */
  readonly rate: number;
  /** The film begins again after its last frame, where the format can say so. */
  readonly endlessly: boolean;
  /** The colour below translucent pixels, as `#rrggbb`; null keeps the transparency. */
  readonly background: string | null;
  /** The colour that soft edges of a transparent GIF are mixed with. */
  readonly matte: string;
  /** Of WebM and MP4: bits for each pixel. */
  readonly bits: number;
  /** Of WebM and MP4. */
  readonly codec: CodecChoice | null;
  /** Names the files in a zip. */
  readonly name: string;
}

/** Where the bytes go: to a file that the person has picked, or into the answer to `end`. */
export type FilmTarget = FileSystemFileHandle | null;

/** To the worker itself: begins a film. Everything about this film goes through the port. */
export interface BeginFilm {
  readonly settings: FilmSettings;
  /** A GIF has the colours of this picture, in straight alpha. Null for other formats. */
  readonly picture: Uint8Array<ArrayBuffer> | null;
  readonly target: FilmTarget;
  /** The address of the module of the film encoders. */
  readonly encoder: string;
  readonly port: MessagePort;
}
