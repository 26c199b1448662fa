/** The types of `c2warp/core`. They do not depend on browser types, so programs for Node can use them. */
import type { Inspection as Report, Stage } from '../compute/generated/report';
import type { PointWeights, PosedMesh } from '../compute/points';
import type { Point } from '../document/generated/project';
import type { Round, RoundPoint, SiteStudy, Study } from '../document/generated/study';
import type { ProjectFile, Rotation } from '../document/project';
import type { Area } from '../geometry/area';

/** Pixels in straight (not premultiplied) alpha: RGBA, one byte each, rows from top to bottom. */
export interface PixelData {
  readonly width: number;
  readonly height: number;
  /** `width × height × 4` bytes. */
  readonly data: Uint8Array | Uint8ClampedArray;
}

/** An `ImageBitmap`. */
interface BitmapSource {
  readonly width: number;
  readonly height: number;
  close(): void;
}

/** An `HTMLCanvasElement` or an `OffscreenCanvas`. */
interface CanvasSource {
  readonly width: number;
  readonly height: number;
  getContext(id: '2d'): unknown;
}

/** A `Blob` or a `File`. */
interface FileSource {
  readonly size: number;
  readonly type: string;
  arrayBuffer(): Promise<ArrayBuffer>;
}

/**
 * A picture: pixels such as an `ImageData`, or the bytes of a file. Pages and workers also take an `ImageBitmap` or a
 * canvas.
 *
 * Browsers decode PNG, JPEG, WebP and others. Node only decodes PNG: see {@link WarperOptions.decode}. A 2D canvas
 * stores premultiplied colours, so translucent pixels of a canvas or bitmap are rounded.
 */
export type PictureInput =
  | PixelData
  | ArrayBuffer
  | ArrayBufferView
  | FileSource
  | BitmapSource
  | CanvasSource;

/** A warped picture: an `ImageData` in pages and workers, the same properties in Node. */
export type WarpedImage = typeof globalThis extends { ImageData: { prototype: infer Image } }
  ? Image
  : { readonly width: number; readonly height: number; readonly data: Uint8ClampedArray<ArrayBuffer> };

/** A `WebAssembly.Module`. */
export type SolverModule = typeof globalThis extends { WebAssembly: { Module: { prototype: infer Module } } }
  ? Module
  : object;

export interface Cancellable {
  /** Rejects the call with the signal's reason. A solve ends after its present stage, a drawing after a few rows. */
  readonly signal?: AbortSignal | undefined;
}

export interface WarperOptions extends Cancellable {
  /**
   * Whether a worker solves and draws. Default: true in a page; false in a worker and in Node, where the caller's
   * thread works in steps of some milliseconds.
   */
  readonly worker?: boolean;
  /** The compiled solver. Default: `c2warp_bg.wasm` of this package, loaded once. */
  readonly module?: SolverModule;
  /** Its compiled later part. Default: `c2warp_later_bg.wasm`, loaded when a call first needs it. */
  readonly laterModule?: SolverModule;
  /** Decodes a file instead of the built-in decoder, for example JPEG in Node. */
  readonly decode?: (bytes: Uint8Array<ArrayBuffer>) => PixelData | Promise<PixelData>;
}

/**
 * A project, or the text of a project file. By default, `format` is `c2warp/1`, `image` has the picture's size, and
 * `handles` is empty.
 */
export type ProjectInput = string | Partial<ProjectFile>;

export interface SolveOptions extends Cancellable {
  /** Called with each finished stage. */
  readonly onProgress?: (stage: Stage) => void;
}

/** The pose of a handle. Missing values are taken from the project. */
export interface HandlePose {
  /** The posed point, or one for each corner of a bar or polygon, in image pixels. */
  readonly posed?: Point | readonly Point[];
  /** Degrees, or `'auto'`. */
  readonly rotation?: Rotation;
  /** Above 0. */
  readonly scale?: number;
  readonly depth?: number;
}

/** The sites of a solution: the origins of its weights. */
export interface Sites {
  /** Sites × 2: rest positions in image pixels. */
  readonly rest: Float64Array<ArrayBuffer>;
  /** Sites: index of the handle in the project, −1 for a virtual site, −2 for a site of a held boundary. */
  readonly handle: Int32Array<ArrayBuffer>;
}

/** The mesh of a solution at rest, with the weights of its vertices in rows. */
export interface Mesh {
  /** Vertices × 2, in image pixels: first the samples of the domain, then a skirt around them. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Triangles × 3 vertices, in drawing order. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** Vertices + 1: vertex v has the entries `offsets[v]` to `offsets[v + 1]` of `sites` and `weights`. */
  readonly offsets: Uint32Array<ArrayBuffer>;
  readonly sites: Uint32Array<ArrayBuffer>;
  readonly weights: Float32Array<ArrayBuffer>;
}

/** Posed points. */
export interface MappedPoints {
  /** Points × 2: posed positions; NaN for a point outside the domain. */
  readonly posed: Float64Array<ArrayBuffer>;
  /** Points: determinant of the Jacobian, the growth of areas; NaN outside the domain. */
  readonly det: Float64Array<ArrayBuffer>;
}

export interface RestPoints {
  /** Points × 2: the point of the picture that is drawn there; NaN where nothing is drawn. */
  readonly rest: Float64Array<ArrayBuffer>;
}

export interface WarpOptions extends Cancellable {
  /** Pixels of the result per pixel of the picture. Left out: 1. */
  readonly scale?: number;
  /**
   * The rectangle to draw: that of the picture (default), `grown` to contain everything that is drawn, or `covered`,
   * the smallest such rectangle.
   */
  readonly area?: Area;
  /** For pixel art: takes the nearest pixel, and mixes no colours. Default: false. */
  readonly pixelated?: boolean;
  /** Called with the drawn fraction, up to 1. */
  readonly onProgress?: (part: number) => void;
}

export interface WarpedPicture {
  readonly image: WarpedImage;
  /** Position of the picture's upper left corner in the image, in pixels: [0, 0] unless `area` is given. */
  readonly origin: readonly [x: number, y: number];
}

export type { Area, Point, PointWeights, PosedMesh, Report, Round, RoundPoint, SiteStudy, Stage, Study };
