/** Segments: a row of buttons with one selected. */
import { css } from './css';

export const segmentsStyle = css`
  .segments {
    display: flex;
    /* Long words get a second row. */
    flex-wrap: wrap;
    gap: 2px;
    margin: 6px 0;
    padding: 2px;
    border-radius: calc(0.8 * var(--_radius));
    background: var(--_raised);
  }
  .segment {
    flex: 1;
    min-width: min-content;
    height: 28px;
    border-radius: var(--_radius-item);
  }
  .button.segment[aria-pressed='true'] {
    /* Light on dark surfaces too. */
    background: color-mix(in srgb, #fff 21%, var(--_surface));
    color: var(--_text);
    box-shadow: 0 1px 2px light-dark(#0000002b, #0009);
  }
  @media (prefers-contrast: more) {
    .button.segment[aria-pressed='true'] {
      box-shadow: inset 0 0 0 1.5px currentcolor;
    }
  }
`;
