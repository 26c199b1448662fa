/**
 * Shared colours, type and shapes.
 *
 * A page restyles the editor through the `--c2-*` properties; the editor itself reads the names with an underscore.
 */
import { css } from 'lit';

export const theme = css`
  :host {
    color-scheme: light dark;
    --_accent: var(--c2-accent, light-dark(#2558e8, #7ea2ff));
    --_on-accent: light-dark(#fff, #0c1430);
    --_surface: var(--c2-surface, light-dark(#fff, #232427));
    --_text: var(--c2-text, light-dark(#1e1f22, #ececea));
    /* What lies between the two follows a page that sets them. */
    --_raised: color-mix(in srgb, var(--_text) 6.5%, var(--_surface));
    --_line: color-mix(in srgb, var(--_text) 12%, var(--_surface));
    --_faint: color-mix(in srgb, var(--_text) 66%, var(--_surface));
    --_ground: var(--c2-ground, light-dark(#f5f5f3, #191a1c));
    --_checker: var(--c2-checker, light-dark(#ebebe8, #1f2023));
    --_warning: light-dark(#9a5b00, #f0b45a);
    --_danger: light-dark(#b3261e, #ff8f85);
    --_radius: var(--c2-radius, 10px);
    --_shadow: 0 1px 2px light-dark(#0000000f, #0006), 0 6px 24px light-dark(#00000014, #0007);
    --_speed: 140ms;
    display: block;
    position: relative;
    min-height: 240px;
    overflow: clip;
    background: var(--_ground);
    color: var(--_text);
    font: 13px / 1.4 var(--c2-font, ui-sans-serif, system-ui, 'Segoe UI', Roboto, 'Noto Sans', sans-serif);
    font-variant-numeric: tabular-nums;
    /* What the page says of its text is not meant for these words, nor for where things stand. */
    direction: ltr;
    text-align: left;
    text-indent: 0;
    text-transform: none;
    text-shadow: none;
    letter-spacing: normal;
    word-spacing: normal;
    word-break: normal;
    overflow-wrap: normal;
    white-space: normal;
    -webkit-tap-highlight-color: transparent;
  }
  :host([hidden]) {
    display: none;
  }
  :host([theme='light']) {
    color-scheme: light;
  }
  :host([theme='dark']) {
    color-scheme: dark;
  }
  :host([disabled]) {
    opacity: 0.6;
    pointer-events: none;
  }
  *,
  *::before,
  *::after {
    box-sizing: border-box;
  }
  :focus:not(:focus-visible),
  .shell {
    outline: none;
  }
  :focus-visible {
    outline: 2px solid var(--_accent);
    outline-offset: 1px;
  }
  p,
  h2,
  h3,
  ul {
    margin: 0;
    padding: 0;
    list-style: none;
  }
  .card {
    background: var(--_surface);
    border: 1px solid var(--_line);
    border-radius: var(--_radius);
    box-shadow: var(--_shadow);
  }
  .faint {
    color: var(--_faint);
  }
  .icon {
    width: 20px;
    height: 20px;
    flex: none;
  }
  .button,
  .link,
  .primary,
  .item {
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
    min-width: 34px;
    height: 34px;
    padding: 0 7px;
    border-radius: 7px;
    transition: background var(--_speed);
  }
  .button.worded {
    padding: 0 10px 0 8px;
  }
  .button:hover:not(:disabled, [aria-pressed='true']),
  .item:hover {
    background: var(--_raised);
  }
  .button:active:not(:disabled) {
    background: var(--_line);
  }
  .button[aria-pressed='true'] {
    background: var(--_accent);
    color: var(--_on-accent);
  }
  .button:disabled,
  .link:disabled {
    opacity: 0.35;
    cursor: default;
  }
  .button.small {
    min-width: 26px;
    height: 26px;
    padding: 0 3px;
  }
  .link {
    color: var(--_accent);
    padding: 4px 6px;
    border-radius: 5px;
    font-weight: 600;
    white-space: nowrap;
  }
  .link:hover:not(:disabled) {
    text-decoration: underline;
  }
  .primary {
    height: 44px;
    padding: 0 20px;
    border-radius: 22px;
    background: var(--_accent);
    color: var(--_on-accent);
    font-weight: 600;
  }
  .spoken {
    position: absolute;
    width: 1px;
    height: 1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }

  /* Tooltips: what it does, and the key for it. */
  @media (hover: hover) {
    [data-tip]:hover::after,
    [data-tip]:focus-visible::after {
      content: attr(data-tip) '   ' attr(data-keys);
      position: absolute;
      z-index: 5;
      top: calc(100% + 7px);
      left: 50%;
      translate: -50% 0;
      padding: 4px 9px;
      border-radius: 6px;
      background: light-dark(#26272b, #ececea);
      color: light-dark(#fff, #1e1f22);
      font-size: 12px;
      font-weight: 400;
      white-space: pre;
      pointer-events: none;
      animation: appear var(--_speed) 350ms backwards;
    }
    .tools [data-tip]:hover::after,
    .tools [data-tip]:focus-visible::after {
      top: 50%;
      left: calc(100% + 9px);
      translate: 0 -50%;
    }
    /* At an edge they grow away from it. */
    .brand + .group [data-tip]:hover::after,
    .brand + .group [data-tip]:focus-visible::after {
      left: 0;
      translate: none;
    }
    .top > .theme[data-tip]:hover::after,
    .top > .theme[data-tip]:focus-visible::after {
      left: auto;
      right: 0;
      translate: none;
    }
    .status [data-tip]:hover::after,
    .status [data-tip]:focus-visible::after,
    .panel [data-tip]:hover::after,
    .panel [data-tip]:focus-visible::after,
    .draft-bar [data-tip]:hover::after,
    .draft-bar [data-tip]:focus-visible::after {
      top: auto;
      bottom: calc(100% + 7px);
      left: auto;
      right: 0;
      translate: none;
    }
  }
  @keyframes appear {
    from {
      opacity: 0;
    }
  }
  @media (prefers-reduced-motion: reduce) {
    :host {
      --_speed: 0s;
    }
    *,
    *::before,
    *::after {
      animation: none !important;
    }
  }
`;
