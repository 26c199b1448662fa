/** The draft of a bar or polygon, and the bar with its buttons. */
import { css } from './css';
import { phone } from './layouts';

export const drawingStyle = css`
  .draft {
    stroke-linejoin: round;
  }
  .draft .line {
    stroke: var(--_handle);
    stroke-width: var(--_stroke);
  }
  .draft .line.under {
    stroke: var(--_casing);
    stroke-width: var(--_cased);
  }
  .draft .closing {
    opacity: 0.7;
  }
  .draft .corner {
    fill: var(--_casing);
    stroke: var(--_handle);
    stroke-width: var(--_stroke);
  }
  .draft .target {
    stroke-width: 3;
  }
  .draft .hot {
    fill: var(--_handle);
    stroke: var(--_casing);
  }
  .draft-bar {
    display: flex;
    align-items: center;
    gap: 2px;
    padding-block: 4px;
    padding-inline: 14px 4px;
    animation: appear var(--_speed);
  }
  .draft-bar .words {
    min-width: 0;
    margin-inline-end: 10px;
    line-height: 1.25;
    color: var(--_faint);
  }
  @container ${phone} {
    /* Two rows: the words and the switch, and the buttons. */
    .draft-bar:has(.edge-switch) {
      flex-wrap: wrap;
      justify-content: flex-end;
      width: 340px;
      padding-inline-start: 14px;
    }
    .draft-bar:has(.edge-switch) .words {
      flex: 1 0 140px;
      margin: 0;
    }
    .draft-bar .edge-switch {
      padding-inline-end: 4px;
    }
  }
  .button.finish {
    padding-block: 0;
    padding-inline: 8px 12px;
    background: var(--_accent);
    color: var(--_on-accent);
    font-weight: 600;
  }
  .button.finish:hover:not(:disabled) {
    background: color-mix(in srgb, var(--_accent) 88%, var(--_text));
  }
  .button.finish:disabled {
    background: var(--_raised);
    color: color-mix(in srgb, var(--_faint) 60%, transparent);
  }
  @container ${phone} {
    .button.finish {
      padding-block: 0;
      padding-inline: 10px 14px;
    }
  }
`;
