/** Check boxes, the menu of a phone, and the context menu. */
import { css } from './css';
import { lowestPhone, phone } from './layouts';

export const menuStyle = css`
  .menu {
    position: relative;
  }
  .menu.more {
    display: none;
  }
  .popover {
    --_width: 208;
    max-width: calc(100vw - 12px);
    max-height: calc(100dvh - 70px);
    overflow: auto;
    position: fixed;
    inset: auto;
    margin: 0;
    padding: 6px;
    color: inherit;
  }
  .check {
    display: flex;
    align-items: center;
    gap: 6px;
    min-height: 28px;
    overflow-wrap: anywhere;
    padding-block: 0;
    padding-inline: 8px 2px;
    border-radius: var(--_radius-item);
    cursor: pointer;
  }
  .check:hover {
    background: var(--_raised);
  }
  .check input {
    width: 16px;
    height: 16px;
    margin: 0;
    accent-color: var(--_accent);
  }
  .context {
    max-width: calc(100vw - 8px);
    max-height: calc(100dvh - 8px);
    overflow: auto;
    user-select: none;
    -webkit-user-select: none;
  }
  .context:focus {
    outline: none;
  }
  .context hr {
    margin: 6px -6px;
    border: 0;
    border-top: 1px solid var(--_line);
  }
  .entry {
    display: flex;
    align-items: center;
    gap: 9px;
    min-height: 30px;
    padding-block: 0;
    padding-inline: 8px 10px;
    border-radius: var(--_radius-item);
    cursor: default;
  }
  .context.tap .entry {
    min-height: var(--_finger);
  }
  .more .entry {
    width: 100%;
    border: 0;
    background: none;
    color: inherit;
    font: inherit;
    text-align: start;
  }
  /* The card of tools has it where there is room. */
  .more [data-entry='brush'] {
    display: none;
  }
  .more .entry:disabled {
    color: color-mix(in srgb, currentcolor 35%, transparent);
  }
  .entry:focus {
    background: var(--_raised);
  }
  .entry:focus-visible {
    outline-offset: -2px;
  }
  :host(:not(.keyed)) .entry:focus-visible {
    outline: none;
  }
  .entry[aria-disabled] {
    color: color-mix(in srgb, currentcolor 35%, transparent);
  }
  .entry .why {
    display: block;
    margin-top: -1px;
    padding-bottom: 3px;
    color: var(--_faint);
    font-size: 12px;
  }
  .entry kbd {
    margin-inline-start: auto;
    padding-inline-start: 20px;
    color: color-mix(in srgb, currentcolor 66%, transparent);
    font: inherit;
    font-size: 12px;
    white-space: nowrap;
  }
  @media (hover: none) {
    .entry kbd {
      display: none;
    }
  }
  @container ${lowestPhone} {
    .more [data-entry='brush'] {
      display: flex;
    }
  }
  @container ${phone} {
    .menu.more {
      display: block;
    }
    .popover {
      min-width: 200px;
    }
  }
`;
