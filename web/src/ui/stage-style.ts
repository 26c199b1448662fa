/** The stage: a quiet checkerboard, the canvas on it, the handles over it. */
import { css } from 'lit';

export const stageStyle = css`
  .stage {
    position: absolute;
    inset: 0;
    /* The focus scrolls what is hidden into view, and the picture away from its handles; clipped, nothing scrolls. */
    overflow: clip;
    touch-action: none;
    user-select: none;
    -webkit-user-select: none;
    background: repeating-conic-gradient(var(--_checker) 0 25%, transparent 0 50%) 50% / 24px 24px var(--_ground);
  }
  /* The focus that a press gives shows nowhere: keys alone show where they go. */
  .stage:focus-visible {
    outline: none;
  }
  :host(.keyed) .stage:focus-visible {
    outline: 2px solid var(--_accent);
    outline-offset: -3px;
  }
  canvas,
  .marks {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    pointer-events: none;
  }
  .handles {
    position: absolute;
    inset: 0 auto auto 0;
    width: 0;
    height: 0;
  }

  .handle {
    position: absolute;
    left: 0;
    top: 0;
    width: 44px;
    height: 44px;
    margin: -22px 0 0 -22px;
    padding: 0;
    border: 0;
    background: none;
    cursor: inherit;
    border-radius: 50%;
  }
  .handle::before {
    content: '';
    position: absolute;
    inset: 14px;
    border-radius: 50%;
    background: #fff;
    border: 3.5px solid var(--c2-handle, #2558e8);
    box-shadow:
      0 0 0 1.5px #fff,
      0 1px 5px 1px #0007;
    transition: scale var(--_speed);
  }
  .handle:hover::before {
    scale: 1.14;
  }
  .handle[aria-pressed='true']::before {
    background: var(--c2-handle, #2558e8);
    border-width: 2.5px;
    border-color: #fff;
    box-shadow:
      0 0 0 2px var(--c2-handle, #2558e8),
      0 1px 5px 2px #0006;
  }
  .handle:focus-visible {
    outline: none;
  }
  /* The ends of a bar, the corners of a polygon: smaller than a point handle, as there are more of them. */
  .handle.corner::before {
    inset: 16px;
    border-width: 2.5px;
  }
  .handle.corner.selected::before {
    inset: 15.5px;
    box-shadow: 0 1px 5px 1px #0008;
  }
  /* The middle of a bar or polygon takes the focus and shows nothing else: the line itself is what is held. */
  .handle.middle-mark::before,
  .handle.middle-mark[aria-pressed='true']::before {
    inset: 18.5px;
    border: 0;
    background: #fff;
    box-shadow: 0 0 0 1.5px var(--c2-handle, #2558e8);
  }
  .handle.middle-mark[aria-pressed='false']:not(:focus-visible)::before {
    opacity: 0;
  }
  .handles.drawing {
    opacity: 0.45;
  }
  :host(.keyed) .handle:focus-visible::before {
    outline: 2px solid #fff;
    outline-offset: 2px;
    box-shadow:
      0 0 0 2px var(--c2-handle, #2558e8),
      0 0 0 6px var(--c2-handle, #2558e8);
  }
  @media (pointer: coarse) {
    .handle::before {
      inset: 12px;
    }
    .handle.corner::before,
    .handle.corner.selected::before {
      inset: 14px;
    }
  }
  .inviting .handle::after {
    content: '';
    position: absolute;
    inset: 14px;
    border-radius: 50%;
    border: 2px solid #fff;
    animation: invite 1.8s ease-out infinite;
  }
  @keyframes invite {
    from {
      opacity: 0.9;
    }
    70%,
    to {
      scale: 2.6;
      opacity: 0;
    }
  }

  /* Layers of their own: a drag repaints neither the other, and Chromium leaves no ghosts of old marks. */
  .marks,
  .handle {
    will-change: transform;
  }
  .marks {
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
  .line-handle,
  .draft {
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
  .draft.waiting {
    opacity: 0.6;
  }
  .draft .line {
    stroke: var(--c2-handle, #2558e8);
    stroke-width: 2.5;
  }
  .draft .line.under {
    stroke: #fff;
    stroke-width: 5.5;
  }
  .draft .closing {
    opacity: 0.7;
  }
  .draft .corner {
    fill: #fff;
    stroke: var(--c2-handle, #2558e8);
    stroke-width: 2.5;
  }
  .draft .target {
    stroke-width: 3;
  }
  .draft .hot {
    fill: var(--c2-handle, #2558e8);
    stroke: #fff;
  }
  /* What is turned over has next to no width: its rim has to show it. */
  .folds {
    fill: #f0250f;
    stroke: #f0250f;
    stroke-width: 2.5;
    stroke-linejoin: round;
  }
  .folds.pale {
    fill: none;
    stroke: #fffc;
    stroke-width: 6;
  }
  .box {
    fill: color-mix(in srgb, var(--_accent) 14%, transparent);
    stroke: var(--_accent);
  }
  .graph {
    stroke: #1263ad;
    stroke-width: 1.25;
  }
  .graph.pale {
    stroke: #fff8;
    stroke-width: 3;
  }
  .sites {
    stroke: #0b8a56;
    stroke-width: 7;
  }
  .sites.pale {
    stroke: #fff;
    stroke-width: 10;
  }
  .comparing :is(.marks, .handles) {
    opacity: 0;
  }

  .empty {
    position: absolute;
    inset: 0;
    display: grid;
    place-content: center;
    justify-items: center;
    gap: 14px;
    color: var(--_faint);
    font-size: 15px;
  }
  /* Most pictures are there before anybody could read it. */
  .empty.opening {
    animation: appear var(--_speed) 350ms backwards;
  }
  :host(.dropping) .stage::after {
    content: '';
    position: absolute;
    inset: 10px;
    border: 2px dashed var(--_accent);
    border-radius: 14px;
    background: color-mix(in srgb, var(--_accent) 8%, transparent);
  }
`;
