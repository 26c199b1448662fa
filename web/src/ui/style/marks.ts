/** What is drawn beside the dots: lines of bars and polygons, rest places, rings, frame, crosshair, selection box. */
import { css } from 'lit';

export const marksStyle = css`
  /* Marks and handles are layers of their own: a drag repaints neither the other, and Chromium leaves no ghosts of old marks. */
  .marks {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    pointer-events: none;
    will-change: transform;
    fill: none;
    stroke-linecap: round;
  }
  .under {
    stroke: #0006;
    stroke-width: 3.5;
  }
  .rest {
    stroke: #fff;
    stroke-width: 1.5;
    opacity: 0.8;
  }
  .rest .under {
    stroke: #0005;
    stroke-width: 3;
  }
  .rest .dots {
    stroke-width: 2.25;
  }
  .rest .dots.under {
    stroke-width: 4;
  }
  .frame {
    stroke-linecap: butt;
    animation: appear var(--_speed) backwards;
  }
  .frame .pale {
    stroke: #fffb;
    stroke-width: 1.25;
  }
  .frame .dashes {
    stroke: #26272bd9;
    stroke-width: 1.25;
    stroke-dasharray: 5 5;
  }
  .ring {
    stroke: #fff;
    stroke-width: 1.75;
  }
  .knob {
    fill: #fff;
    stroke: var(--c2-handle, #2558e8);
    stroke-width: 2.5;
  }
  .crosshair {
    stroke: #fff;
    stroke-width: 1.75;
  }
  .line-handle {
    stroke-linejoin: round;
  }
  .casing {
    stroke: #fff;
    stroke-width: 5.5;
    filter: drop-shadow(0 1px 1.5px #0008);
  }
  .line-handle .line {
    stroke: var(--c2-handle, #2558e8);
    stroke-width: 2.5;
  }
  .line-handle.selected .casing {
    stroke-width: 7.5;
  }
  .line-handle.selected .line {
    stroke-width: 4;
  }
  .body {
    fill: var(--c2-handle, #2558e8);
    opacity: 0.09;
  }
  .line-handle.selected .body {
    opacity: 0.16;
  }
  .box {
    fill: color-mix(in srgb, var(--_accent) 14%, transparent);
    stroke: var(--_accent);
  }
`;
