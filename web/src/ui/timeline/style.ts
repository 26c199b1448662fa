/** The timeline: a bar of controls, a ruler, and a row for each handle. Below the stage in every layout. */

import { OVER_TIMELINE, PHONE, TIMELINE, TOOLS } from '../../editor/sizes';
import { css } from '../style/css';
import { phone } from '../style/layouts';
import { ORDER } from '../style/order';

export const timelineStyle = css`
  .timeline {
    --_names: 128px;
    --_row: 28px;
    --_side: 16px;
    --_key: 12px;
    flex: none;
    z-index: ${ORDER.status};
    display: flex;
    flex-direction: column;
    height: min(${TIMELINE.height}px, ${TIMELINE.share}%);
    border-top: 1px solid var(--_line);
    background: var(--_surface);
    outline: none;
    touch-action: pan-x pan-y;
    user-select: none;
  }
  .clip-bar {
    flex: none;
    display: flex;
    align-items: center;
    gap: 4px;
    min-height: 44px;
    padding: 0 8px;
    overflow-x: auto;
    /* The button that closes lies above the end of the bar. */
    scroll-padding-inline-end: 56px;
    scrollbar-width: none;
    border-bottom: 1px solid var(--_line);
  }
  .clip-bar > *,
  .clip-bar .of-keys > *,
  .clip-bar .clip-name > * {
    flex: none;
  }
  .clip-bar .gap {
    flex: 1 0 0;
  }
  .clip-bar .clip-name,
  .clip-bar .of-keys {
    display: flex;
    align-items: center;
    gap: 2px;
  }
  .clip-bar .view-tools {
    display: flex;
    gap: 2px;
  }
  /* Within reach, however narrow the bar is. */
  .clip-bar .closer {
    position: sticky;
    z-index: 1;
    inset-inline-end: -8px;
    margin-inline-end: -8px;
    padding: 4px 8px;
    background: var(--_surface);
  }
  .clip-bar .of-keys {
    margin-inline-start: 4px;
    padding-inline-start: 8px;
    border-inline-start: 1px solid var(--_line);
  }
  .clip-bar .field {
    width: 118px;
  }
  .clip-bar .record[aria-pressed='true'] {
    background: var(--_danger);
    color: var(--_surface);
  }
  .clip-name .choice {
    max-width: 160px;
    font-weight: 600;
  }
  .first-clip {
    flex: 1;
    display: flex;
    flex-direction: column;
    align-items: center;
    justify-content: center;
    gap: 12px;
    padding: 8px 16px;
    text-align: center;
    color: var(--_faint);
  }
  .first-clip p {
    margin: 0;
  }
  .clip-presets {
    display: flex;
    flex-wrap: wrap;
    justify-content: center;
    gap: 8px;
  }
  .clip-presets .button {
    padding: 0 16px;
    background: var(--_raised);
    color: var(--_text);
    font-weight: 600;
  }
  .clip-presets .preset {
    background: var(--_accent);
    color: var(--_on-accent);
  }
  .clip-presets .preset:hover:not(:disabled, [aria-pressed='true'], .on) {
    background: color-mix(in srgb, var(--_accent) 86%, var(--_text));
  }
  .clip-presets .preset:disabled {
    background: var(--_raised);
  }
  .lanes {
    flex: 1;
    min-height: 0;
    overflow: auto;
    overscroll-behavior: contain;
  }
  .ruler-row,
  .key-row {
    display: flex;
    width: max-content;
    min-width: 100%;
  }
  .ruler-row {
    position: sticky;
    z-index: 2;
    top: 0;
    background: var(--_surface);
  }
  .now,
  .track-name {
    position: sticky;
    z-index: 1;
    inset-inline-start: 0;
    flex: none;
    width: var(--_names);
    background: var(--_surface);
    border: 0;
    border-inline-end: 1px solid var(--_line);
  }
  .now {
    padding: 4px 12px;
    font-size: 12px;
    font-weight: 600;
    font-variant-numeric: tabular-nums;
    line-height: 20px;
  }
  .track-name {
    height: var(--_row);
    padding: 0 12px;
    overflow: hidden;
    color: inherit;
    font: inherit;
    font-size: 12px;
    text-align: start;
    text-overflow: ellipsis;
    white-space: nowrap;
    cursor: pointer;
  }
  .track-name::first-letter {
    text-transform: uppercase;
  }
  .track-name:hover {
    background: var(--_raised);
  }
  .key-row.selected .track-name {
    box-shadow: inset calc(3px * var(--_way)) 0 0 var(--_accent);
    font-weight: 600;
  }
  .key-row.selected .lane {
    background: color-mix(in srgb, var(--_accent) 8%, transparent);
  }
  .ruler,
  .lane {
    flex: 1;
    position: relative;
    padding: 0 var(--_side);
  }
  .ruler {
    height: 28px;
    border-bottom: 1px solid var(--_line);
    cursor: ew-resize;
    touch-action: none;
  }
  .lane {
    height: var(--_row);
    border-bottom: 1px solid color-mix(in srgb, var(--_line) 60%, transparent);
  }
  .tracks {
    position: relative;
  }
  .time {
    position: relative;
    height: 100%;
    width: var(--_time-width, 100%);
  }
  .second {
    position: absolute;
    bottom: 3px;
    translate: -50%;
    color: var(--_faint);
    font-size: 11px;
    font-variant-numeric: tabular-nums;
    pointer-events: none;
  }
  .second::before {
    content: '';
    position: absolute;
    left: 50%;
    bottom: -3px;
    height: 4px;
    border-left: 1px solid var(--_bound);
  }
  .playhead {
    position: absolute;
    z-index: 1;
    top: 0;
    bottom: -1px;
    width: 0;
    border-left: 1.5px solid var(--_accent);
    translate: -0.75px;
    pointer-events: none;
  }
  .recording .playhead {
    border-color: var(--_danger);
  }
  .ruler .playhead::before {
    content: '';
    position: absolute;
    top: 0;
    left: -7px;
    width: 12.5px;
    height: 13px;
    border-radius: 3px 3px 6.5px 6.5px;
    background: var(--_accent);
  }
  .recording .ruler .playhead::before {
    background: var(--_danger);
  }
  /* The diamond in the middle of a larger target. */
  .clip-key {
    position: absolute;
    top: 0;
    width: var(--_row);
    height: var(--_row);
    padding: 0;
    border: 0;
    background: none;
    translate: -50%;
    cursor: pointer;
    touch-action: none;
  }
  .clip-key::before {
    content: '';
    position: absolute;
    inset: calc((var(--_row) - var(--_key)) / 2);
    border: 1.5px solid var(--_text);
    border-radius: 2px;
    background: var(--_surface);
    rotate: 45deg;
  }
  .clip-key.linear::before {
    background: linear-gradient(45deg, var(--_text) 50%, var(--_surface) 50%);
  }
  .clip-key.hold::before {
    rotate: none;
  }
  .clip-key:hover::before {
    border-color: var(--_accent);
  }
  .clip-key[aria-pressed='true'] {
    z-index: 1;
  }
  .clip-key[aria-pressed='true']::before {
    border-color: var(--_accent);
    background: var(--_accent);
  }
  /* A press focuses the key, and its colour shows that. */
  :host(:not(.keyed)) .clip-key:focus-visible {
    outline: none;
  }
  /* Keyboard commands apply to keys, so the marks of their handles are less prominent. */
  .of-keys .handle[aria-pressed='true']:not(.middle-mark, .behind)::before {
    background: var(--_casing);
    border: 3.5px solid var(--_handle);
    box-shadow:
      0 0 0 1.5px var(--_casing),
      0 1px 5px 1px #0007;
  }
  .of-keys :is(.ring, .line-handle.selected) {
    opacity: 0.45;
  }
  .of-keys :is(.item[aria-pressed='true'], .item[aria-pressed='true'] .dot, .key-row.selected .lane) {
    background: none;
  }
  .of-keys .key-row.selected .track-name {
    box-shadow: none;
  }
  .key-box {
    position: absolute;
    z-index: 2;
    border: 1px solid var(--_accent);
    background: color-mix(in srgb, var(--_accent) 12%, transparent);
    pointer-events: none;
  }
  @media (pointer: coarse) {
    .timeline {
      --_row: var(--_finger);
      --_side: 22px;
      --_key: 15px;
      height: min(${TIMELINE.coarse}px, ${TIMELINE.share}%);
    }
    .clip-bar {
      min-height: 52px;
    }
    .ruler,
    .now {
      height: var(--_finger);
    }
  }
  /* The tools keep clear of it in two columns, or four. */
  @container shell (width >= ${PHONE}px) and (height < ${OVER_TIMELINE.low}px) {
    .middle:has(~ .timeline) {
      --_start: ${TOOLS.low.fine}px;
    }
    .middle:has(~ .timeline) .tools {
      display: grid;
      grid-template-columns: auto auto;
    }
  }
  @container shell (width >= ${PHONE}px) and (height < ${OVER_TIMELINE.lowest}px) {
    .middle:has(~ .timeline) {
      --_start: ${TOOLS.lowest.fine}px;
    }
    .middle:has(~ .timeline) .tools {
      grid-template-columns: repeat(4, auto);
      /* The least elements have room for one row. */
      overflow: hidden auto;
    }
    .middle:has(~ .timeline) .tools [data-tip]::after {
      content: none;
    }
  }
  @media (pointer: coarse) {
    @container shell (width >= ${PHONE}px) and (height < ${OVER_TIMELINE.lowest}px) {
      .middle:has(~ .timeline) {
        --_start: ${TOOLS.lowest.coarse}px;
      }
    }
  }
  @container ${phone} {
    .timeline {
      --_names: 92px;
    }
  }
  @media (forced-colors: active) {
    .clip-key[aria-pressed='true']::before {
      background: Highlight;
    }
    .playhead {
      border-color: Highlight;
    }
  }
`;
