/** Where hints, the drawing bar and notices stand: over the picture, beside the cards, clear of one another. */
import { css } from 'lit';

export const floatingStyle = css`
  .hint,
  .draft-bar,
  .notice {
    --_free: calc(100% - var(--_left) - var(--_right) - 16px);
    position: absolute;
    z-index: 2;
    bottom: 16px;
    left: calc((100% + var(--_left) - var(--_right)) / 2);
    width: max-content;
    max-width: var(--_free);
    translate: -50% 0;
  }
  .hint {
    bottom: 22px;
  }
  @container shell (width >= 640px) {
    :is(.draft-bar, .hint:not(.bubble)) ~ .notice {
      bottom: 70px;
    }
  }
  @container shell (width < 640px) {
    .hint:not(.bubble) {
      bottom: 84px;
    }
    .draft-bar {
      bottom: 78px;
    }
    .notice {
      top: 12px;
      bottom: auto;
    }
    /* Clear of the sheet, wherever it is, and of one another. */
    .panel.open:not(.high) ~ :is(.hint:not(.bubble), .draft-bar) {
      top: 12px;
      bottom: auto;
    }
    .panel.open:not(.high) ~ :is(.hint:not(.bubble), .draft-bar) ~ .notice {
      top: 72px;
    }
    .panel.high ~ .notice {
      top: auto;
      bottom: 84px;
    }
    .panel.high ~ .hint:not(.bubble) ~ .notice {
      bottom: 134px;
    }
  }
  /* No tools below: what is said and drawn goes to the edge. */
  @container shell (width < 640px) and (height < 372px) {
    .hint:not(.bubble),
    .draft-bar {
      bottom: 8px;
    }
    .notice {
      top: 8px;
    }
    .panel.high ~ .notice {
      bottom: 8px;
    }
  }
`;
