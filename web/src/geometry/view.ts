/** Where the picture lies on the canvas, and what is drawn of it. Lengths are device pixels. */
export interface View {
  /** Device pixels per image pixel. */
  readonly scale: number;
  /** Where the image's origin, its top left corner, lies on the canvas. */
  readonly x: number;
  readonly y: number;
  /** Size of the canvas. */
  readonly width: number;
  readonly height: number;
  /** Device pixels per CSS pixel, 1 where it is left out: lines are as wide as that. */
  readonly pixelRatio?: number;
  /** Draw the picture as it was, for comparison. */
  readonly compare?: boolean;
  readonly overlays?: Overlays;
}

/** What may be drawn over the picture. */
export interface Overlays {
  /** The triangles that the picture is drawn with. */
  readonly mesh?: boolean;
}
