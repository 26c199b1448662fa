/** Buttons and links of all kinds. */
import { css } from './css';
import { phone } from './layouts';

export const buttonsStyle = css`
  .button,
  .link,
  .primary {
    font: inherit;
    color: inherit;
    border: 0;
    background: none;
    cursor: pointer;
  }
  .button {
    position: relative;
    display: inline-flex;
    align-items: center;
    justify-content: center;
    gap: 6px;
    min-width: var(--_control);
    height: var(--_control);
    padding: 0 7px;
    border-radius: var(--_radius-control);
    transition: background var(--_speed);
  }
  .caption {
    display: none;
  }
  .button.worded {
    padding-block: 0;
    padding-inline: 8px 10px;
  }
  .button:hover:not(:disabled, [aria-pressed='true'], .on) {
    background: var(--_raised);
  }
  .button:active:not(:disabled) {
    background: var(--_line);
  }
  .button:is([aria-pressed='true'], .on) {
    background: var(--_accent);
    color: var(--_on-accent);
  }
  .button:disabled,
  .link:disabled {
    cursor: default;
  }
  .link:disabled {
    opacity: 0.35;
  }
  /* No opacity: the tooltip would inherit it. */
  .button:disabled {
    color: color-mix(in srgb, currentcolor 35%, transparent);
  }
  .button[aria-pressed='true']:disabled {
    background: color-mix(in srgb, var(--_accent) 35%, transparent);
    color: var(--_on-accent);
  }
  .button.small {
    min-width: 26px;
    height: 26px;
    padding: 0 3px;
  }
  .link {
    color: var(--_accent);
    padding: 4px 6px;
    border-radius: var(--_radius-item);
    font-weight: 600;
    white-space: nowrap;
  }
  .link:hover:not(:disabled) {
    text-decoration: underline;
  }
  .primary {
    height: var(--_finger);
    padding: 0 20px;
    border-radius: calc(2.2 * var(--_radius));
    background: var(--_accent);
    color: var(--_on-accent);
    font-weight: 600;
  }
  @container ${phone} {
    .button:has(.caption) {
      flex-direction: column;
      gap: 1px;
      padding-inline: 0;
    }
    .button:has(.caption) .icon {
      width: 18px;
      height: 18px;
    }
    .caption {
      display: block;
      max-width: 100%;
      overflow: hidden;
      text-overflow: ellipsis;
      white-space: nowrap;
      font-size: 10px;
      line-height: 1.1;
      letter-spacing: -0.01em;
    }
  }
  @container shell (width < 360px) {
    .caption {
      font-size: 9px;
      letter-spacing: -0.03em;
    }
  }
  .toggle,
  .segment {
    color: var(--_faint);
    font-size: 12px;
    font-weight: 550;
  }
`;
