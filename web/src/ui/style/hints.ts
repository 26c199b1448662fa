/** Hints over the picture, and the bubble that points at a handle. */
import { css } from './css';
import { lowPhone, phone } from './layouts';

export const hintsStyle = css`
  .hint {
    --_veil: light-dark(#26272bee, #ececeaee);
    padding: 9px 18px;
    border-radius: 20px;
    background: var(--_veil);
    color: var(--_on-inverse);
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
    border-radius: 26px;
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
      border-radius: 22px;
      font-size: 13px;
    }
    .hint.suggests .primary {
      height: var(--_finger);
    }
  }
  /* The bubble belongs to the picture, so it lies under the cards. */
  .hint.bubble {
    right: auto;
    bottom: auto;
    z-index: auto;
    white-space: nowrap;
    translate: 26px -50%;
  }
  .bubble::before {
    content: '';
    position: absolute;
    top: calc(50% - 7px);
    right: 100%;
    border: 7px solid transparent;
    border-left: 0;
    border-right-color: var(--_veil);
  }
  .hint.bubble.above {
    translate: -75% calc(-100% - 28px);
  }
  .bubble.above::before {
    inset: 100% auto auto calc(75% - 7px);
    border: 7px solid transparent;
    border-bottom: 0;
    border-top-color: var(--_veil);
  }
  @container ${lowPhone} {
    .hint:not(.bubble) {
      padding: 6px 12px;
      font-size: 13px;
    }
  }
`;
