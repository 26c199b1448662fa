/**
 * The camera: how the picture is scaled and shifted on the stage, in CSS pixels.
 *
 * A camera is a value; every function returns a new one. The renderer's `View` holds the same in device pixels.
 */
import type { Box } from './box';
import { distance, midpoint, type Vec } from './vec';
import type { View } from './view';

export interface Camera {
  /** CSS pixels per image pixel. */
  readonly scale: number;
  /** Where the image's origin lies on the stage, CSS pixels. */
  readonly x: number;
  readonly y: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Space that the editor's controls cover at the edges of the stage, CSS pixels. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** From a 16,384 px picture shown as a thumbnail to single pixels the size of a thumb. */
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

/** The camera scaled so that the image point under `anchor` (stage pixels) stays under it. */
export function scaledAt(camera: Camera, scale: number, anchor: Vec): Camera {
  const next = clampScale(scale);
  const ratio = next / camera.scale;
  return {
    scale: next,
    x: anchor[0] + (camera.x - anchor[0]) * ratio,
    y: anchor[1] + (camera.y - anchor[1]) * ratio,
  };
}

/** The camera that centres a box of the image in the stage without its insets, as large as it fits. */
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

/** The camera after two fingers moved from `before` to `after`: it follows their midpoint and their distance. */
export function pinched(camera: Camera, before: readonly [Vec, Vec], after: readonly [Vec, Vec]): Camera {
  const spread = distance(...before);
  const from = midpoint(...before);
  const to = midpoint(...after);
  const turned = spread > 0 ? scaledAt(camera, (camera.scale * distance(...after)) / spread, from) : camera;
  return panned(turned, [to[0] - from[0], to[1] - from[1]]);
}

/** The camera in device pixels, for the renderer. */
export const deviceView = (camera: Camera, stage: Size, pixelRatio: number): View => ({
  scale: camera.scale * pixelRatio,
  x: camera.x * pixelRatio,
  y: camera.y * pixelRatio,
  width: Math.max(1, Math.round(stage.width * pixelRatio)),
  height: Math.max(1, Math.round(stage.height * pixelRatio)),
  pixelRatio,
});
