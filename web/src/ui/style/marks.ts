/** Marks beside the dots: lines of bars and polygons, rest positions, rings, frame, crosshair, selection box. */
import { css } from './css';

export const marksStyle = css`
  /* Marks and handles have separate layers. A drag repaints one of them only, and Chromium leaves no old marks. */
  .marks {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    pointer-events: none;
    will-change: transform;
    --_stroke: 2.5;
    --_cased: 5.5;
    fill: none;
    stroke-linecap: round;
  }
  .under {
    stroke: #0009;
    stroke-width: 3.5;
  }
  .rest {
    stroke: var(--_casing);
    stroke-width: 1.5;
    opacity: 0.8;
  }
  .rest .under {
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
  :is(.frame, .domain) .pale {
    stroke: #fffb;
    stroke-width: 1.25;
  }
  :is(.frame, .domain) .dashes {
    stroke: #26272bd9;
    stroke-width: 1.25;
    stroke-dasharray: 5 5;
  }
  .ring-corner {
    fill: var(--_casing);
    stroke: #26272b;
    stroke-width: 1.25;
  }
  .ring-corner.in-hand {
    fill: var(--_handle);
    stroke: var(--_casing);
    stroke-width: 2;
  }
  .domain .veil {
    fill: #0006;
    stroke: none;
  }
  .guides {
    stroke: #d6186f;
    stroke-width: 1;
    stroke-linecap: butt;
  }
  .guides .pale {
    stroke: #fffa;
    stroke-width: 3;
  }
  .marks .name {
    fill: var(--_casing);
    stroke: #1b1c20d9;
    stroke-width: 3.5;
    stroke-linejoin: round;
    paint-order: stroke;
    font-size: 12px;
    font-weight: 650;
    text-anchor: middle;
    dominant-baseline: central;
  }
  .marks .number {
    font-size: 11px;
  }
  .ring {
    stroke: var(--_casing);
    stroke-width: 1.75;
  }
  .knob {
    fill: var(--_casing);
    stroke: var(--_handle);
    stroke-width: var(--_stroke);
  }
  .early {
    fill: var(--_handle);
    stroke: var(--_casing);
    stroke-width: 2;
  }
  .crosshair {
    stroke: var(--_casing);
    stroke-width: 1.75;
  }
  .line-handle {
    stroke-linejoin: round;
  }
  .casing {
    stroke: var(--_casing);
    stroke-width: var(--_cased);
    filter: drop-shadow(0 1px 1.5px #0008);
  }
  .line-handle .line {
    stroke: var(--_handle);
    stroke-width: var(--_stroke);
  }
  .line-handle.selected .casing {
    stroke-width: 7.5;
  }
  .line-handle.selected .line {
    stroke-width: 4;
  }
  .body {
    fill: var(--_handle);
    opacity: 0.09;
  }
  .line-handle.selected .body {
    opacity: 0.16;
  }
  .asked {
    stroke: var(--_casing);
    stroke-width: 1.75;
    opacity: 0;
    transition: opacity 0.5s ease-in;
  }
  .asked.held {
    opacity: 1;
    transition: none;
  }
  .asked .shape {
    stroke: #c2410c;
    stroke-width: 2.5;
    stroke-dasharray: 4 4;
    fill: #fff9;
  }
  .asked .words {
    fill: #26272b;
    stroke: none;
  }
  .asked text {
    fill: #fff;
    font-size: 13px;
    font-weight: 500;
    text-anchor: middle;
  }
  .box {
    fill: color-mix(in srgb, var(--_accent) 14%, transparent);
    stroke: var(--_accent);
  }
`;
