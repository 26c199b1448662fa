/** The rim of the brush, and the bar with its settings. */
import { css } from './css';
import { phone } from './layouts';

export const brushStyle = css`
  .brush circle {
    fill: none;
    stroke: var(--_handle);
    stroke-width: var(--_stroke);
  }
  .brush .under {
    stroke: var(--_casing);
    stroke-width: var(--_cased);
  }
  .brush.erasing circle:not(.under) {
    stroke-dasharray: 5 4;
  }
  .brush-bar {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    justify-content: center;
    gap: 2px 12px;
    padding-block: 4px;
    padding-inline: 8px 6px;
    animation: appear var(--_speed);
  }
  .brush-bar .segments {
    margin: 0;
  }
  .brush-bar .kind {
    flex: none;
    gap: 5px;
    min-width: 34px;
    padding: 0 7px;
  }
  .brush-bar .name {
    font-size: 13px;
  }
  .brush-bar .option {
    display: flex;
    align-items: center;
    gap: 6px;
    font-size: 13px;
  }
  .brush-bar .option span {
    color: var(--_faint);
  }
  .brush-bar [type='range'] {
    width: 96px;
    min-width: 0;
    margin: 0;
    accent-color: var(--_accent);
  }
  .brush-bar output {
    min-width: 42px;
    font-variant-numeric: tabular-nums;
  }
  /* A row of their own, as wide as the others make the bar. */
  .brush-bar .words {
    flex: none;
    width: 0;
    min-width: 100%;
    justify-content: center;
    text-align: center;
    display: flex;
    align-items: center;
    gap: 8px;
    margin: 2px 0;
    color: var(--_faint);
  }
  @media (pointer: coarse) {
    .brush-bar [type='range'] {
      height: var(--_finger);
    }
  }
  @container ${phone} {
    .brush-bar {
      gap: 0 8px;
      padding: 2px 4px;
    }
    .brush-bar [type='range'] {
      width: 74px;
    }
    .brush-bar output {
      display: none;
    }
    /* Two rows: the buttons, and the sliders. */
    .brush-bar .segments,
    .brush-bar .clear {
      order: -1;
    }
    .brush-bar .name {
      display: none;
    }
    .brush-bar .kind {
      min-width: 40px;
    }
    .brush-bar .option {
      flex: 1 1 34%;
      justify-content: center;
    }
  }
`;
