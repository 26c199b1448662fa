/** The messages between the page and the worker that makes an export with a solver. */

import type { EngineFormat, EngineLoss } from '../document/engine_rig';
import type { MapFile } from '../document/map_file';

type Bytes = Uint8Array<ArrayBuffer>;

/** A rig for web pages. */
export interface WebRigOrder {
  readonly kind: 'web-rig';
  /** A PNG, WebP or JPEG file of the picture. */
  readonly file: Bytes;
  /** Whether readers may pose the handles in any mode. */
  readonly posable: boolean;
}

/** A rig for a game engine. */
export interface EngineRigOrder {
  readonly kind: 'engine-rig';
  readonly format: EngineFormat;
  /** The most bones besides the root, the most that move a vertex, and the most vertices. */
  readonly bones: number;
  readonly influences: number;
  readonly vertices: number;
  /** Names the files. */
  readonly stem: string;
  /** The name of the zip with all files; null for separate files. */
  readonly zip: string | null;
}

/** A map of the warp, a heat map, or weights. */
export interface MapOrder {
  readonly kind: 'map';
  readonly file: MapFile;
  /** The name of the picture's file. */
  readonly picture: string;
  /** Whether the picture is drawn as pixel art. */
  readonly pixelated: boolean;
  /** The name of the clip that poses the handles at a time in seconds; null for the pose of the project. */
  readonly clip: string | null;
  readonly time: number;
}

/** A drawing with bent paths. */
export interface DrawingOrder {
  readonly kind: 'drawing';
  readonly svg: string;
  /** Whether the frame grows to hold all that is bent beyond it. */
  readonly grow: boolean;
  /** The name of the clip that poses the handles at a time in seconds; null for the pose of the project. */
  readonly clip: string | null;
  readonly time: number;
}

export interface BentDrawing {
  readonly svg: string;
  /** Descriptions of parts that are left out or do not bend. */
  readonly remarks: readonly string[];
}

/** A drawing as a picture of a size in pixels. */
export interface PictureOrder {
  readonly kind: 'picture';
  readonly svg: string;
  readonly width: number;
  readonly height: number;
}

export interface DrawnPicture {
  /** Null if a browser draws it quickly. */
  readonly png: Bytes | null;
  /** Whether text of the drawing is missing. */
  readonly lacksTexts: boolean;
}

export interface ExportedFile {
  readonly name: string;
  readonly bytes: Bytes;
}

export interface EngineRig {
  readonly files: readonly ExportedFile[];
  readonly loss: EngineLoss;
}

/** All orders by their kinds, each with its result. */
export interface Exports {
  readonly 'web-rig': { readonly order: WebRigOrder; readonly made: Bytes };
  readonly 'engine-rig': { readonly order: EngineRigOrder; readonly made: EngineRig };
  readonly map: { readonly order: MapOrder; readonly made: Bytes };
  readonly drawing: { readonly order: DrawingOrder; readonly made: BentDrawing };
}

export type ExportOrder = Exports[keyof Exports]['order'];

/** Asks the worker for an export of a solved project. The worker gets one message: this or a `PictureRequest`. */
export interface ExportRequest {
  /** Compiled by the page. */
  readonly module: WebAssembly.Module;
  /** JSON text. */
  readonly project: string;
  readonly width: number;
  readonly height: number;
  /** The pixels arrive here, or null if the picture was released. */
  readonly pixels: MessagePort;
  readonly order: ExportOrder;
}

/** Asks the worker for a picture of a drawing, without a solver. */
export interface PictureRequest {
  readonly module: WebAssembly.Module;
  readonly order: PictureOrder;
}

export type ExportReply =
  /** The part that is done, from 0 to 1. */
  | { readonly part: number }
  | { readonly made: Exports[keyof Exports]['made'] | DrawnPicture }
  /** A sentence for people, or null if the module broke. */
  | { readonly refused: string | null };
