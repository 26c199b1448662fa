/** The solver that all figures share, with the gingerbread figure. It is loaded when the first figure starts. */
import type * as Core from '../../../src/core';
import { Ground } from './ground';
import { POINTS, SIZE } from './sizes';

export interface Scene {
  readonly warper: Core.Warper;
  readonly ground: Ground;
  /** A second solver with the same picture, for a figure that compares two solutions. */
  second(): Promise<Core.Warper>;
}

let opened: Promise<Scene> | undefined;

/** The scene of the page. A call after a failure tries again. */
export function scene(): Promise<Scene> {
  opened ??= open().catch((error: unknown) => {
    opened = undefined;
    throw error;
  });
  return opened;
}

async function open(): Promise<Scene> {
  const { createWarper }: typeof Core = await import(
    /* @vite-ignore */ new URL(`${import.meta.env.BASE_URL}core/core.js`, document.baseURI).href
  );
  const pixels = await picture();
  const warper = await createWarper(pixels);
  const solution = await warper.solve({ samples: POINTS });
  const { outline } = await solution.study();
  let other: Promise<Core.Warper> | undefined;
  return {
    warper,
    ground: new Ground(solution, outline),
    second() {
      other ??= createWarper(pixels);
      return other;
    },
  };
}

/** The drawing is small and has any size, unlike its pixels. */
async function picture(): Promise<ImageData> {
  const image = new Image();
  image.src = new URL(`${import.meta.env.BASE_URL}samples/gingerbread.svg`, document.baseURI).href;
  await image.decode();
  const { width, height } = SIZE;
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no 2D canvas');
  context.drawImage(image, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}
