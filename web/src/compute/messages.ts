/** The messages between a solver and its owner, such as a worker and its page. */

import type { Lens } from '../document/generated/lens';
import type { Study } from '../document/generated/study';
import type { C2WarpErrorCode } from '../error';
import type { Area } from '../geometry/area';
import type { Wording } from '../texts/wording';
import type { PointWeights, PosedMesh } from './points';
import type { CellBorders, FillData, PixelSource, SolutionData, Stage } from './solution';

export interface DrawingOptions {
  /** Pixels of the drawing per pixel of the picture. */
  readonly scale: number;
  readonly area: Area;
  /** For pixel art: no colours are mixed. */
  readonly pixelated: boolean;
}

/** A time of a clip. The handles go along the clip from its beginning. */
export interface Moment {
  /** As JSON. Its tracks name the handles as the project does. */
  readonly clip: string;
  /** Seconds. */
  readonly time: number;
}

export interface FilmOptions extends Omit<DrawingOptions, 'area'> {
  /** Frames a second. */
  readonly rate: number;
  /** The beginning and the end of the part to show, in seconds; null for the whole clip. */
  readonly range: readonly [from: number, to: number] | null;
}

export interface FilmSize {
  /** Names the film in later requests. */
  readonly film: number;
  /** Of all frames. */
  readonly width: number;
  readonly height: number;
  readonly frames: number;
  /** The film begins again after its last frame. */
  readonly endlessly: boolean;
}

export interface DrawingSize {
  /** Names the drawing in later requests. */
  readonly drawing: number;
  readonly width: number;
  readonly height: number;
  /** The picture's upper left corner in the drawing. */
  readonly origin: readonly [x: number, y: number];
  /** Bands start at multiples of this number of rows. */
  readonly bandRows: number;
}

/** Points × 2: x and y. */
export type Points = Float64Array<ArrayBuffer>;

/** A pose that continues others, in full precision: sites × 7, as in `Pose::motion_numbers` of the Rust core. */
export interface SiteMotions {
  readonly motions: Float64Array<ArrayBuffer>;
}

export interface PosedRequest {
  readonly project: string;
  /** Null: the pose depends on the handles of the project only. */
  readonly history: Moment | SiteMotions | null;
}

/** Name of a request → [body, response]. Projects are sent as JSON text. */
export interface Messages {
  /** The picture of all later requests. */
  picture: [request: PixelSource, response: null];
  /** Fits a project to the picture. Answers with JSON. `own`: the project's picture, if outlines count. */
  fit: [request: { readonly project: string; readonly own: PixelSource | null }, response: string];
  /** Stopped, and answered as superseded, when a newer solve or another picture arrives. */
  solve: [request: { readonly project: string }, response: SolutionData];
  /**
   * Fills the picture behind the domain of a project that is solved; null if it has no fill. A newer fill or another
   * picture ends it. A solve has priority, and the fill continues after it.
   */
  fill: [request: { readonly project: string }, response: FillData | null];
  /** Stops a solve as a newer one would. */
  stop: [request: null, response: null];
  /** Prepares the warped picture at full quality. It is drawn by `rows` until `release`. */
  draw: [request: PosedRequest & DrawingOptions, response: DrawingSize];
  /** Suggests handles beside those of the project. Answers with the JSON of a `Suggestion`. */
  suggest: [request: { readonly project: string }, response: string];
  /** Some rows of a drawing. */
  rows: [
    request: { readonly drawing: number; readonly from: number; readonly to: number },
    response: Uint8Array<ArrayBuffer>,
  ];
  release: [request: { readonly drawing: number }, response: null];
  /** Prepares the frames of a clip, which `frame` draws until `release-film`. The clip is JSON. */
  film: [request: { readonly project: string; readonly clip: string } & FilmOptions, response: FilmSize];
  /** Grows all frames to hold all that one of them draws. Sent for each of them before one is drawn. */
  include: [request: { readonly film: number; readonly frame: number }, response: FilmSize];
  /** Prepares a frame, which is drawn by `rows` as any drawing. */
  frame: [request: { readonly film: number; readonly frame: number }, response: DrawingSize];
  /** Prepares the whole picture at the scale of a film: it has the colours of all frames. */
  'at-rest': [request: { readonly film: number }, response: DrawingSize];
  'release-film': [request: { readonly film: number }, response: null];
  /** Points × 3: posed x and y, and the growth of areas. NaN outside the domain. */
  map: [request: PosedRequest & { readonly points: Points }, response: Float64Array<ArrayBuffer>];
  /** The rest points that are drawn at places. NaN where nothing is drawn. */
  inverse: [request: PosedRequest & { readonly points: Points }, response: Points];
  'posed-mesh': [request: PosedRequest, response: PosedMesh];
  /** Continues a pose to the handles of the project `next`, as in a drag. `settles`: it comes to rest there. */
  'next-pose': [
    request: PosedRequest & { readonly next: string; readonly settles: boolean },
    response: SiteMotions['motions'],
  ];
  /** The poses of handles at a moment, in the layout of `document/handle_poses`. The handles are JSON. */
  'clip-poses': [
    request: { readonly handles: string; readonly moment: Moment },
    response: Float64Array<ArrayBuffer>,
  ];
  /** The weights of rest points, in rows. */
  weights: [request: { readonly project: string; readonly points: Points }, response: PointWeights];
  /** The distances from a place to rest points, in pixels. Infinite where no path leads, NaN outside the domain. */
  distances: [
    request: { readonly project: string; readonly from: readonly [number, number]; readonly points: Points },
    response: Float64Array<ArrayBuffer>,
  ];
  /** The vertices of the shortest path between two places; empty if there is no path. */
  path: [
    request: {
      readonly project: string;
      readonly from: readonly [number, number];
      readonly to: readonly [number, number];
    },
    response: Points,
  ];
  /** The borders between the cells of the project's solution. */
  cells: [request: { readonly project: string }, response: CellBorders];
  /** The project's solution, explained. */
  study: [request: { readonly project: string }, response: Study];
  /** The weights and paths of a rest point; null outside the domain. */
  lens: [
    request: { readonly project: string; readonly at: readonly [number, number] },
    response: Lens | null,
  ];
}

export type Name = keyof Messages;

/** A picture in the form that is sent. Its pixels arrive at the port, or null if the picture was released. */
export interface SentPicture {
  readonly width: number;
  readonly height: number;
  readonly pixels: MessagePort;
}

/** The body of a request in the form that is sent. */
type Sent<N extends Name> = N extends 'picture'
  ? SentPicture
  : N extends 'fit'
    ? { readonly project: string; readonly own: SentPicture | null }
    : Messages[N][0];

/** A request in the form that is sent; every reply to it repeats `id`. */
export type Request = {
  [N in Name]: { readonly id: number; readonly name: N; readonly body: Sent<N> };
}[Name];

/** The first message to a worker: the compiled module, shared with the page. */
export interface Boot {
  readonly module: WebAssembly.Module;
}

/** The later part of the module. It comes before the first request that needs it. */
export interface Extension {
  readonly later: WebAssembly.Module;
}

/** The requests that the first part of the module answers. */
const ANSWERED_AT_ONCE: readonly Name[] = ['picture', 'solve', 'stop'];

export const needsLater = (name: Name): boolean => !ANSWERED_AT_ONCE.includes(name);

/** The progress of a request: the stage of a solve that is done, the part of a fill from 0 to 1. */
export type ProgressOf<N extends Name> = N extends 'solve' ? Stage : N extends 'fill' ? number : never;

/** An error that crossed from the worker. */
export interface Failure {
  readonly code: C2WarpErrorCode;
  readonly message: string;
  /** Ids of the handles that the message names. */
  readonly handles?: readonly string[];
  readonly wording?: Wording | undefined;
}

export type Reply =
  | { readonly id: number; readonly kind: 'done'; readonly body: Messages[Name][1] }
  | { readonly id: number; readonly kind: 'progress'; readonly stage: ProgressOf<Name> }
  | { readonly id: number; readonly kind: 'failed'; readonly failure: Failure }
  /** A newer request has made this one pointless. */
  | { readonly id: number; readonly kind: 'superseded' }
  /** The module panicked: the worker must be replaced. `started`: it had a session, so a request is to blame. */
  | { readonly kind: 'died'; readonly started: boolean; readonly message: string };
