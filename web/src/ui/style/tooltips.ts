/** Tooltips of buttons: what the button does, and the key for it. */
import { css } from 'lit';
import { ORDER } from './order';

export const tooltipsStyle = css`
  @media (hover: hover) {
    [data-tip]:is(:hover, :focus-visible):not([data-dismissed])::after {
      content: attr(data-tip) '   ' attr(data-keys);
      position: absolute;
      z-index: ${ORDER.tooltip};
      top: calc(100% + 7px);
      left: 50%;
      translate: -50% 0;
      padding: 4px 9px;
      border-radius: var(--_radius-item);
      background: var(--_inverse);
      color: var(--_on-inverse);
      font-size: 12px;
      font-weight: 400;
      white-space: pre;
      pointer-events: none;
      animation: appear var(--_speed) 350ms backwards;
    }
    /* An open menu tells what its button is for, and would cover a part of the tooltip. */
    .menu:has(:popover-open) > [data-tip]::after {
      content: none;
    }
    .tools [data-tip]:is(:hover, :focus-visible)::after {
      top: 50%;
      left: calc(100% + 9px);
      translate: 0 -50%;
    }
    /* At an edge they grow away from it. */
    .brand + .group [data-tip]:is(:hover, :focus-visible)::after {
      left: 0;
      translate: none;
    }
    .top > .theme[data-tip]:is(:hover, :focus-visible)::after {
      left: auto;
      right: 0;
      translate: none;
    }
    :is(.status, .panel, .draft-bar) [data-tip]:is(:hover, :focus-visible)::after {
      top: auto;
      bottom: calc(100% + 7px);
      left: auto;
      right: 0;
      translate: none;
    }
  }
`;
