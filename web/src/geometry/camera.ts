/**
 * The camera: scale and position of the picture on the stage, in CSS pixels.
 *
 * A camera is a value: every function returns a new one. The renderer's `View` is the same in device pixels.
 */
import type { Box } from './box';
import { distance, midpoint, type Vec } from './vec';
import type { View } from './view';

export interface Camera {
  /** CSS pixels per image pixel. */
  readonly scale: number;
  /** Position of the image's origin on the stage, CSS pixels. */
  readonly x: number;
  readonly y: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Space at the edges of the stage that controls cover, CSS pixels. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** From a thumbnail of a 16,384 px picture to pixels the size of a thumb. */
export const SCALE_LIMITS = [0.01, 64] as const;

const clampScale = (scale: number): number => Math.min(SCALE_LIMITS[1], Math.max(SCALE_LIMITS[0], scale));

export const toStage = (camera: Camera, p: Vec): Vec => [
  camera.x + camera.scale * p[0],
  camera.y + camera.scale * p[1],
];

export const toImage = (camera: Camera, p: Vec): Vec => [
  (p[0] - camera.x) / camera.scale,
  (p[1] - camera.y) / camera.scale,
];

export const panned = (camera: Camera, by: Vec): Camera => ({
  ...camera,
  x: camera.x + by[0],
  y: camera.y + by[1],
});

/** Returns the camera at another scale; the image point under `anchor` (stage pixels) stays there. */
export function scaledAt(camera: Camera, scale: number, anchor: Vec): Camera {
  const next = clampScale(scale);
  const ratio = next / camera.scale;
  return {
    scale: next,
    x: anchor[0] + (camera.x - anchor[0]) * ratio,
    y: anchor[1] + (camera.y - anchor[1]) * ratio,
  };
}

/** Returns the camera that centres a box of the image between the insets, as large as possible. */
export function fitted({ min, max }: Box, stage: Size, insets: Insets): Camera {
  const width = Math.max(1, stage.width - insets.left - insets.right);
  const height = Math.max(1, stage.height - insets.top - insets.bottom);
  const scale = clampScale(Math.min(width / (max[0] - min[0]), height / (max[1] - min[1])));
  return {
    scale,
    x: insets.left + (width - (min[0] + max[0]) * scale) / 2,
    y: insets.top + (height - (min[1] + max[1]) * scale) / 2,
  };
}

/**
 * Returns the camera moved by the shortest way that keeps a box of the image in view between the insets: half of the
 * box along each axis, or half of the view if the box is longer.
 */
export function keptInView(camera: Camera, { min, max }: Box, stage: Size, insets: Insets): Camera {
  const shift = (from: number, to: number, low: number, high: number): number => {
    const half = Math.max(0, Math.min(to - from, high - low) / 2);
    return Math.max(0, low + half - to) || Math.min(0, high - half - from);
  };
  const [left, top] = toStage(camera, min);
  const [right, bottom] = toStage(camera, max);
  return panned(camera, [
    shift(left, right, insets.left, stage.width - insets.right),
    shift(top, bottom, insets.top, stage.height - insets.bottom),
  ]);
}

/** Returns the camera after two fingers moved: it follows their midpoint and their distance. */
export function pinched(camera: Camera, before: readonly [Vec, Vec], after: readonly [Vec, Vec]): Camera {
  const spread = distance(...before);
  const from = midpoint(...before);
  const to = midpoint(...after);
  const scaled = spread > 0 ? scaledAt(camera, (camera.scale * distance(...after)) / spread, from) : camera;
  return panned(scaled, [to[0] - from[0], to[1] - from[1]]);
}

/** Returns the camera in device pixels, for the renderer. */
export const deviceView = (camera: Camera, stage: Size, pixelRatio: number): View => ({
  scale: camera.scale * pixelRatio,
  x: camera.x * pixelRatio,
  y: camera.y * pixelRatio,
  width: Math.max(1, Math.round(stage.width * pixelRatio)),
  height: Math.max(1, Math.round(stage.height * pixelRatio)),
  pixelRatio,
});
