/** The result of a solve: flat arrays for drawing and for the overlays, and a report of what the solver did. */
import type { Inspection as Report, Stage } from './generated/report';

export type { Report, Stage };

export interface SolutionData {
  /** Vertices × 2: rest positions, image pixels; first the samples, then the vertices of the skirt. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Triangles × 3: vertices, in drawing order while no handle has a depth. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /**
   * Vertices × 2 of the picture around a domain that the project draws by rings: it stays in place, behind the rest.
   */
  readonly backgroundPositions: Float32Array<ArrayBuffer>;
  /** Its triangles × 3; empty for any other domain. */
  readonly backgroundTriangles: Uint32Array<ArrayBuffer>;
  /** Vertices × 2 of the feather, a soft rim that is drawn before the mesh; empty without one. */
  readonly featherPositions: Float32Array<ArrayBuffer>;
  /** The vertex of the mesh that each of them moves with. */
  readonly featherOwners: Uint32Array<ArrayBuffer>;
  /** Their levels: 1 and more is opaque, 0 and less is transparent. */
  readonly featherLevels: Float32Array<ArrayBuffer>;
  /** Its triangles × 3. */
  readonly featherTriangles: Uint32Array<ArrayBuffer>;
  /** Vertices + 1: vertex v has the entries `offsets[v]` to `offsets[v + 1]` of `sites` and `weights`. */
  readonly offsets: Uint32Array<ArrayBuffer>;
  /** Entries: index of a site. */
  readonly sites: Uint32Array<ArrayBuffer>;
  /** Entries: weight of that site. A vertex's weights sum to 1; a vertex without weights stays at rest. */
  readonly weights: Float32Array<ArrayBuffer>;
  /** Sites × 2: rest positions, image pixels. */
  readonly siteRest: Float64Array<ArrayBuffer>;
  /** Sites: index of the handle in the project, −1 for a virtual site. */
  readonly siteHandle: Int32Array<ArrayBuffer>;
  /** Edges × 2: the cell graph, as pairs of sites. */
  readonly siteEdges: Uint32Array<ArrayBuffer>;
  /** Opaque data from which the page poses the picture. */
  readonly poser: Uint8Array<ArrayBuffer>;
  readonly report: Report;
}

/** The filled picture behind a domain. */
export interface FillData {
  /** The box around all that is filled, image pixels: left, top, width and height. */
  readonly box: readonly [left: number, top: number, width: number, height: number];
  /** Its pixels in straight alpha. */
  readonly rgba: Uint8Array<ArrayBuffer>;
}

/** The borders between the cells of a solution: straight pieces, each within one triangle of its mesh. */
export interface CellBorders {
  /** Pieces × 3: vertices of the triangle. */
  readonly corners: Uint32Array<ArrayBuffer>;
  /** Pieces × 2 ends × 3: barycentric coordinates in the triangle. */
  readonly barycentric: Float32Array<ArrayBuffer>;
}

/** A picture in straight alpha: rows from the top, RGBA, a byte each. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array<ArrayBuffer>;
}

/** The pixels of a picture, wherever they are. */
export interface PixelSource {
  readonly width: number;
  readonly height: number;
  /** Sends a copy of the pixels to a port, in straight alpha, or null if the picture was released. */
  sendTo(port: MessagePort): void;
}
