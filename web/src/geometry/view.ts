/** The position of the picture on the canvas, and the drawing options. Lengths are device pixels. */
export interface View {
  /** Device pixels per image pixel. */
  readonly scale: number;
  /** Position of the image's origin, its top left corner, on the canvas. */
  readonly x: number;
  readonly y: number;
  /** Size of the canvas. */
  readonly width: number;
  readonly height: number;
  /** Device pixels per CSS pixel; 1 by default. Lines are one CSS pixel wide. */
  readonly pixelRatio?: number;
  /** Draws the unwarped picture, for comparison. */
  readonly compare?: boolean;
  readonly overlays?: Overlays;
  /** Draws enlarged image pixels as squares. Above 400 % they always are squares. */
  readonly pixelated?: boolean;
  /** The picture moves: each pixel of a shrunk picture is one read of the nearest mip level. */
  readonly moving?: boolean;
  /** Pixels of an export per image pixel, by default 1: enlarged pixel art is drawn on their grid. */
  readonly exportScale?: number;
}

/** Optional overlays drawn by the renderer. */
export interface Overlays {
  /** The triangles of the picture's mesh. */
  readonly mesh?: boolean;
  /** The static background is dimmed: it does not bend. */
  readonly selection?: boolean;
}
