/** A bar or polygon that is being drawn, and the bar with its buttons. */
import { css } from 'lit';

export const drawingStyle = css`
  .draft {
    stroke-linejoin: round;
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
  .draft-bar {
    display: flex;
    align-items: center;
    gap: 2px;
    padding: 4px 4px 4px 14px;
    animation: appear var(--_speed);
  }
  .draft-bar .words {
    min-width: 0;
    margin-right: 10px;
    line-height: 1.25;
    color: var(--_faint);
  }
  .button.finish {
    padding: 0 12px 0 8px;
    background: var(--_accent);
    color: var(--_on-accent);
    font-weight: 600;
  }
  .button.finish:hover:not(:disabled) {
    background: color-mix(in srgb, var(--_accent) 88%, var(--_text));
  }
  .button.finish:disabled {
    background: var(--_raised);
    color: var(--_faint);
  }
  @container shell (width < 640px) {
    .button.finish {
      padding: 0 14px 0 10px;
    }
  }
`;
