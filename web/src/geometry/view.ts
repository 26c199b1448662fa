/** Where the picture lies on the canvas, and what is drawn. Lengths are device pixels. */
export interface View {
  /** Device pixels per image pixel. */
  readonly scale: number;
  /** Where the image's origin, its top left corner, lies on the canvas. */
  readonly x: number;
  readonly y: number;
  /** Size of the canvas. */
  readonly width: number;
  readonly height: number;
  /** Device pixels per CSS pixel, which is the width of lines; 1 by default. */
  readonly pixelRatio?: number;
  /** Draw the unwarped picture, for comparison. */
  readonly compare?: boolean;
  readonly overlays?: Overlays;
  /** Enlarged pixels of the picture are squares. Above 400 % they always are. */
  readonly pixelated?: boolean;
}

/** Optional drawings over the picture. */
export interface Overlays {
  /** The triangles of the picture's mesh. */
  readonly mesh?: boolean;
}
