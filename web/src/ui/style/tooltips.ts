/**
 * Tooltips of buttons: the action, and its key.
 *
 * An invisible bridge lets the pointer move from the button onto its tooltip (WCAG 1.4.13).
 */
import { css } from './css';
import { phone, uprightPhone } from './layouts';
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
      width: max-content;
      max-width: 270px;
      padding: 4px 9px;
      border-radius: var(--_radius-item);
      background: var(--_text);
      color: var(--_surface);
      font-size: 12px;
      font-weight: 400;
      text-align: start;
      white-space: pre-wrap;
      cursor: default;
      /* Kept under reduced motion: without the delay, tooltips hinder a pointer that moves along the buttons. */
      animation: tip var(--_speed) 350ms backwards !important;
    }
    [data-tip]:hover:not([data-dismissed])::before {
      content: '';
      position: absolute;
      z-index: ${ORDER.tooltip};
      inset: 100% 0 -8px;
      animation: tip 0s 350ms backwards !important;
    }
    @keyframes tip {
      from {
        opacity: 0;
        visibility: hidden;
      }
    }
    /* An open menu or list explains its button, and would cover part of the tooltip. */
    .menu:has(:popover-open) > [data-tip]:is(:hover, :focus-visible)::after,
    .menu:has(:popover-open) > [data-tip]:hover::before,
    [data-tip][aria-expanded='true']:is(:hover, :focus-visible)::after,
    [data-tip][aria-expanded='true']:hover::before {
      content: none;
    }
    .tools [data-tip]:is(:hover, :focus-visible)::after {
      top: 50%;
      left: auto;
      inset-inline-start: calc(100% + 9px);
      translate: 0 -50%;
    }
    .tools [data-tip]:hover::before {
      inset-block: 0;
      inset-inline: 100% -10px;
    }
    /* Near an edge, tooltips grow away from it. */
    .brand + .group [data-tip]:is(:hover, :focus-visible)::after {
      left: auto;
      inset-inline-start: 0;
      translate: none;
    }
    .top > .theme[data-tip]:is(:hover, :focus-visible)::after {
      left: auto;
      inset-inline-end: 0;
      translate: none;
    }
    :is(.status, .panel, .draft-bar) [data-tip]:is(:hover, :focus-visible)::after {
      top: auto;
      bottom: calc(100% + 7px);
      left: auto;
      inset-inline-end: 0;
      translate: none;
    }
    :is(.status, .panel, .draft-bar) [data-tip]:hover::before {
      inset: -8px 0 100%;
    }
    /* The panel scrolls and would clip wider ones. */
    .panel [data-tip]:is(:hover, :focus-visible)::after {
      max-width: 190px;
    }
    .panel [data-command='mirror']:is(:hover, :focus-visible)::after {
      inset-inline-end: -72px;
    }
    @container ${phone} {
      .group ~ .group ~ .group [data-tip]:is(:hover, :focus-visible)::after {
        left: auto;
        inset-inline-end: 0;
        translate: none;
      }
      .top .group ~ .group [data-command='compare'][data-tip]:is(:hover, :focus-visible)::after {
        inset-inline-end: -44px;
      }
      /* Tooltips above this row would be hidden: the sheet scrolls, or the bar lies above it. */
      .panel:is(.numbers, .high) .row [data-tip]:is(:hover, :focus-visible)::after {
        top: calc(100% + 7px);
        bottom: auto;
      }
      .panel:is(.numbers, .high) .row [data-tip]:hover::before {
        inset: 100% 0 -8px;
      }
    }
    /* Above the middle of the card. Beside a button, tooltips would cover other buttons and leave the window. */
    @container ${uprightPhone} {
      .tools [data-tip] {
        position: static;
      }
      .tools [data-tip]:is(:hover, :focus-visible)::after {
        top: auto;
        bottom: calc(100% + 7px);
        left: 50%;
        translate: -50% 0;
      }
      .tools [data-tip]:hover::before {
        inset: -8px 0 calc(100% - 5px);
      }
    }
  }
`;
