/** The stage: a faint checkerboard, the canvas on it, and marks and handles on top. */
import { css } from './css';

export const stageStyle = css`
  .stage {
    position: absolute;
    inset: 0;
    /* Focus would scroll hidden handles into view, and move the picture off its handles. Clipping prevents it. */
    overflow: clip;
    touch-action: none;
    user-select: none;
    -webkit-user-select: none;
    background: repeating-conic-gradient(var(--_checker) 0 25%, transparent 0 50%) 50% / 24px 24px var(--_ground);
  }
  /* Focus from a press is not shown, only focus from keys. */
  .stage:focus-visible {
    outline: none;
  }
  /* Drawn over the picture, which would cover an outline of the stage. The pale inner line suits any picture. */
  :host(.keyed) .stage:focus-visible::after {
    content: '';
    position: absolute;
    inset: 0;
    outline: 2px solid var(--_accent);
    outline-offset: -2px;
    box-shadow: inset 0 0 0 3px var(--_surface);
    pointer-events: none;
  }
  canvas {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    pointer-events: none;
  }
  .corner-mark {
    position: absolute;
    inset: 0 auto auto 0;
    pointer-events: none;
  }
  .corner-mark:nth-of-type(2) {
    inset: 0 0 auto auto;
  }
  .corner-mark:nth-of-type(3) {
    inset: auto 0 0 auto;
  }
  .corner-mark:nth-of-type(4) {
    inset: auto auto 0 0;
  }
  .stage.previewing :is(.marks, .handles),
  .stage.previewing ~ .draft-bar,
  .stage.previewing ~ .notices .notice {
    opacity: 0;
    pointer-events: none;
  }
  /* Another picture is on its way, which the next press is for. A short wait is not shown. */
  .stage.awaiting :is(canvas, .handles, .marks > :not(.early)) {
    opacity: 0.4;
    transition: opacity var(--_speed) 250ms;
  }
  :host(.dropping) .stage::after {
    content: '';
    position: absolute;
    inset: 10px;
    border: 2px dashed var(--_accent);
    border-radius: calc(1.4 * var(--_radius));
    background: color-mix(in srgb, var(--_accent) 8%, transparent);
  }
`;
