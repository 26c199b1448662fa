/** The element as a box on any page, and shared styles: focus rings, cards, icons, fading in. */

import { LEAST_HEIGHT, OWN_WIDTH } from '../../editor/sizes';
import { css } from './css';

export const baseStyle = css`
  :host {
    display: block;
    position: relative;
    min-height: ${LEAST_HEIGHT}px;
    /* The content depends on the size of the element, so the element has no width of its own. */
    contain: inline-size;
    contain-intrinsic-width: ${OWN_WIDTH}px;
    overflow: clip;
    background: var(--_ground);
    color: var(--_text);
    font: 13px / 1.4 var(--c2-font, ui-sans-serif, system-ui, 'Segoe UI', Roboto, 'Noto Sans', sans-serif);
    font-variant-numeric: tabular-nums;
    /* Reset inherited text styles: the page means its own text, not the editor. */
    direction: ltr;
    text-align: start;
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
  :host([disabled]) {
    opacity: 0.6;
    pointer-events: none;
  }
  *,
  *::before,
  *::after {
    box-sizing: border-box;
  }
  :focus:not(:focus-visible) {
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
  .spoken {
    position: absolute;
    width: 1px;
    height: 1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
  @keyframes appear {
    from {
      opacity: 0;
    }
  }
  @media (prefers-reduced-motion: reduce) {
    *,
    *::before,
    *::after {
      animation: none !important;
    }
  }
`;
