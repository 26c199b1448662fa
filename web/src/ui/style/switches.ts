/** Switches: a label, an explanation, and a sliding knob. */
import { css } from './css';
import { phone } from './layouts';

export const switchesStyle = css`
  .switch {
    display: flex;
    align-items: center;
    gap: 10px;
    margin-top: 10px;
    padding-top: 10px;
    border-top: 1px solid var(--_line);
  }
  label.switch {
    cursor: pointer;
  }
  .switch + .switch {
    margin-top: 8px;
    padding-top: 0;
    border: 0;
  }
  .switch .text {
    flex: 1;
    font-weight: 600;
    font-size: 12px;
  }
  .switch .faint {
    display: block;
    margin: 0;
    font-weight: 400;
  }
  .switch .field {
    flex: none;
    width: 112px;
  }
  .switch [role='switch'] {
    appearance: none;
    position: relative;
    flex: none;
    width: 34px;
    height: 20px;
    margin: 0;
    border-radius: 10px;
    background: var(--_bound);
    cursor: inherit;
    transition: background var(--_speed);
  }
  .switch [role='switch']::before {
    content: '';
    position: absolute;
    inset-block: 2px;
    inset-inline: 2px auto;
    width: 16px;
    border-radius: 50%;
    background: #fff;
    box-shadow: 0 1px 2px #0005;
    transition: translate var(--_speed);
  }
  .switch [role='switch']:checked {
    background: var(--_accent);
  }
  .switch [role='switch']:checked::before {
    translate: calc(14px * var(--_way)) 0;
  }
  .switch:has(:disabled) {
    opacity: 0.45;
    cursor: default;
  }
  /* In hints and bars: the knob and a few words. */
  .edge-switch {
    display: inline-flex;
    align-items: center;
    gap: 8px;
    height: 34px;
    padding: 0 12px;
    border: 0;
    border-radius: calc(1.7 * var(--_radius));
    background: none;
    color: inherit;
    font: inherit;
    font-size: 13px;
    white-space: nowrap;
    cursor: pointer;
    pointer-events: auto;
  }
  .edge-switch::before {
    content: '';
    flex: none;
    width: 30px;
    height: 18px;
    border-radius: 9px;
    background: radial-gradient(circle at 9px 50%, #fff 6.5px, #fff0 7px) var(--_bound);
  }
  .edge-switch[aria-checked='true']::before {
    background: radial-gradient(circle at 21px 50%, #fff 6.5px, #fff0 7px) var(--_accent);
  }
  @media (pointer: coarse) {
    .edge-switch {
      height: var(--_finger);
    }
  }
  @container ${phone} {
    .switch {
      padding-top: 6px;
      margin-top: 6px;
    }
    .switch + .switch {
      margin-top: 2px;
    }
  }
`;
