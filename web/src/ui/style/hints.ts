/** Hints over the picture, and the bubble that points at a handle. */

import { HINT } from '../../editor/hint_place';
import { NARROW } from '../../editor/sizes';
import { css } from './css';
import { lowHints, phone } from './layouts';

export const hintsStyle = css`
  .hint {
    padding: 9px 18px;
    border: 1px solid var(--_line);
    border-radius: calc(2 * var(--_radius));
    background: var(--_surface);
    box-shadow: var(--_shadow);
    font-size: 14px;
    font-weight: 550;
    text-align: center;
    pointer-events: none;
    animation: appear 400ms 500ms backwards;
  }
  .hint.suggests {
    display: flex;
    align-items: center;
    gap: 14px;
    padding-block: 6px;
    padding-inline: 18px 6px;
    border-radius: calc(2.6 * var(--_radius));
    /* It can be pressed at once. */
    animation-delay: 0ms;
  }
  .hint.suggests .primary {
    display: inline-flex;
    align-items: center;
    gap: 7px;
    height: 34px;
    padding-block: 0;
    padding-inline: 11px 15px;
    white-space: nowrap;
    pointer-events: auto;
  }
  @container ${phone} {
    .hint.suggests {
      flex-direction: column;
      gap: 6px;
      padding: 10px 16px;
      border-radius: calc(2.2 * var(--_radius));
      font-size: 13px;
    }
    .hint.suggests .primary {
      height: var(--_finger);
    }
  }
  /* Low: at most two short lines, below the middle of the picture. */
  @container ${lowHints} {
    .hint {
      padding: 5px 12px;
      font-size: 13px;
      line-height: 1.3;
    }
    .hint.suggests {
      padding-inline-end: 5px;
    }
    .hint > span {
      display: -webkit-box;
      -webkit-box-orient: vertical;
      -webkit-line-clamp: 2;
      overflow: hidden;
    }
  }
  /* Only the button or the switch. */
  @container ${lowHints} and (width < ${NARROW}px) {
    .hint.suggests {
      padding: 0;
    }
    .hint.suggests:has(.primary) {
      border: 0;
      background: none;
      box-shadow: none;
    }
    .hint.suggests > span {
      display: none;
    }
    .hint .edge-switch {
      min-width: 0;
      line-height: 1.2;
      text-align: start;
      white-space: normal;
    }
  }
  /* The bubble belongs to the picture, so it lies under the cards. */
  .hint.bubble {
    right: auto;
    bottom: auto;
    z-index: auto;
    max-width: ${HINT.widest}px;
    translate: ${HINT.apart}px -50%;
    text-wrap: balance;
  }
  .hint.bubble.left {
    translate: calc(-100% - ${HINT.apart}px) -50%;
  }
  .hint.bubble.above {
    translate: calc(-100% * var(--_along)) calc(-100% - ${HINT.apart}px);
  }
  .hint.bubble.below {
    translate: calc(-100% * var(--_along)) ${HINT.apart}px;
  }
  /* Its point: a corner of a square on the edge. */
  .bubble::before {
    content: '';
    position: absolute;
    top: calc(50% - 6px);
    left: -6.5px;
    width: 12px;
    height: 12px;
    border: inherit;
    border-width: 0 0 1px 1px;
    background: inherit;
    rotate: 45deg;
  }
  .bubble.left::before {
    left: auto;
    right: -6.5px;
    rotate: 225deg;
  }
  .bubble:is(.above, .below)::before {
    top: auto;
    bottom: -6.5px;
    left: calc(100% * var(--_along) - 6px);
    rotate: -45deg;
  }
  .bubble.below::before {
    top: -6.5px;
    bottom: auto;
    rotate: 135deg;
  }
`;
