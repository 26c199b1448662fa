/**
 * The one WebGL context of all players of a page, and their frames.
 *
 * Every frame is drawn on a detached canvas, and copied to the player's own canvas. A browser limits the number of
 * contexts, but not the number of copies.
 */

import { C2WarpError } from '../error';
import type { RigClip } from './clip';
import { type Order, STRIDE, writeMotions } from './clip';
import { type Figure, figureOf } from './figure';
import type { Loaded } from './library';
import { type Painter, painterOf, type View } from './painter';

/** Draws a frame at a time in milliseconds. Returns whether another frame is needed. */
export type Frame = (now: number) => boolean;

export interface Stage {
  /** Requests one frame. */
  ask(frame: Frame): void;
  cancel(frame: Frame): void;
  /** Draws a rig at a frame of a clip, and copies it. Nothing happens while the context is lost. */
  show(
    loaded: Loaded,
    clip: RigClip,
    at: number,
    order: Order,
    view: View,
    to: CanvasRenderingContext2D,
  ): void;
  forget(loaded: Loaded): void;
}

let only: Stage | undefined;

/** @throws C2WarpError if the browser has no WebGL2. */
export const stage = (): Stage => {
  only ??= created();
  return only;
};

function created(): Stage {
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl2', { antialias: true, depth: false });
  if (!gl) throw new C2WarpError('webgl', 'This browser cannot draw with WebGL2.');
  const frames = new Set<Frame>();
  const figures = new Map<Loaded, Figure>();
  let painter: Painter | undefined = painterOf(gl);
  let motions = new Float32Array();
  /** All shown players, which draw again after a context loss. */
  const shown = new Set<Frame>();

  canvas.addEventListener('webglcontextlost', (event) => {
    // Otherwise it is not restored.
    event.preventDefault();
    painter = undefined;
    figures.clear();
  });
  canvas.addEventListener('webglcontextrestored', () => {
    painter = painterOf(gl);
    for (const frame of shown) ask(frame);
  });

  let isAsked = false;
  const tick = (now: number) => {
    isAsked = false;
    const due = [...frames];
    frames.clear();
    for (const frame of due) if (frame(now)) ask(frame);
  };
  const ask = (frame: Frame) => {
    frames.add(frame);
    shown.add(frame);
    if (!isAsked) requestAnimationFrame(tick);
    isAsked = true;
  };

  return {
    ask,
    cancel(frame) {
      frames.delete(frame);
      shown.delete(frame);
    },
    show(loaded, clip, at, order, view, to) {
      if (!painter || gl.isContextLost()) return;
      const { rig, picture } = loaded;
      const figure = figures.get(loaded) ?? figureOf(gl, rig, picture);
      figures.set(loaded, figure);
      const length = (rig.rest.length / 2) * STRIDE;
      if (motions.length < length) motions = new Float32Array(length);
      const own = motions.subarray(0, length);
      writeMotions(clip, rig.rest, at, own);
      figure.pose(own);
      const { width, height } = view;
      // It only grows: each change of its size clears it and allocates memory again.
      if (canvas.width < width) canvas.width = width;
      if (canvas.height < height) canvas.height = height;
      painter.draw(rig, figure, order, view);
      to.globalCompositeOperation = 'copy';
      to.drawImage(canvas, 0, canvas.height - height, width, height, 0, 0, width, height);
    },
    forget(loaded) {
      figures.get(loaded)?.dispose();
      figures.delete(loaded);
    },
  };
}
