/** Number fields with the buttons beside them, and lists to choose from. */
import { css } from './css';
import { phone } from './layouts';

export const fieldsStyle = css`
  .fields {
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: 6px;
    margin: 10px 0 6px;
  }
  .choice {
    height: var(--_control);
    padding: 0 6px;
    border: 1px solid transparent;
    border-bottom-color: var(--_bound);
    border-radius: var(--_radius-control);
    background: var(--_raised);
    color: inherit;
    font: inherit;
    font-size: 13px;
  }
  .choice:disabled {
    opacity: 0.45;
  }
  @media (pointer: coarse) {
    .choice {
      height: var(--_finger);
      font-size: 16px;
    }
  }
  .field {
    position: relative;
    display: flex;
    align-items: center;
    height: var(--_control);
    padding: 0 7px;
    border: 1px solid transparent;
    border-bottom-color: var(--_bound);
    border-radius: var(--_radius-control);
    background: var(--_raised);
    cursor: text;
  }
  .field:focus-within {
    border-color: var(--_accent);
    background: var(--_surface);
  }
  .field .label,
  .field .unit {
    color: var(--_faint);
    font-size: 12px;
  }
  .field input {
    flex: 1;
    width: 0;
    min-width: 0;
    padding: 0 4px;
    border: 0;
    outline: none;
    background: none;
    color: inherit;
    font: inherit;
    text-align: right;
    appearance: textfield;
  }
  .field input::-webkit-inner-spin-button {
    display: none;
  }
  .fields.of-corner {
    margin: 2px 0 6px;
  }
  .fields > :nth-child(n + 3) {
    grid-column: 1 / -1;
  }
  .pair {
    display: flex;
    gap: 6px;
  }
  .pair .field {
    flex: 1;
  }
  .toggle {
    padding: 0 11px;
    background: var(--_raised);
  }
  .button.toggle[aria-pressed='true'] {
    background: color-mix(in srgb, var(--_accent) 14%, transparent);
    color: var(--_accent);
    box-shadow: inset 0 0 0 1.5px currentcolor;
  }
  .pair:has([aria-pressed='true']) input:not(:focus) {
    color: var(--_faint);
  }
  @container ${phone} {
    /* As wide as the numbers need. Fields that do not fit on a line wrap to the next. */
    .fields {
      grid-area: fields;
      display: flex;
      flex-wrap: wrap;
      margin: 4px 0 0;
    }
    .fields.of-corner {
      grid-area: of-corner;
    }
    .fields > :nth-child(n) {
      flex: 1 1 28%;
    }
    .fields > :nth-child(n).turn {
      order: 1;
      flex-basis: 41%;
      min-width: 132px;
    }
    .fields > :nth-child(n).depth {
      order: 2;
      flex-basis: 51%;
      min-width: 174px;
    }
    .field {
      padding: 0 6px;
    }
    .field input {
      padding-block: 0;
      padding-inline: 3px 0;
    }
    .pair.turn {
      gap: 4px;
    }
    .pair.depth {
      gap: 0;
    }
    .field .unit {
      display: none;
    }
  }
`;
