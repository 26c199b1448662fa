/** The positions of hints, drawing bar and notices: over the picture, beside the cards, without overlaps. */
import { css } from './css';
import { lowHints, lowPhone, notPhone, phone } from './layouts';
import { ORDER } from './order';

export const floatingStyle = css`
  .hint,
  .draft-bar,
  .brush-bar,
  .notice {
    --_free: calc(100% - var(--_start) - var(--_end) - 16px);
    position: absolute;
    z-index: ${ORDER.floating};
    bottom: 16px;
    inset-inline-start: calc((100% + var(--_start) - var(--_end)) / 2);
    width: max-content;
    max-width: var(--_free);
    translate: calc(-50% * var(--_way)) 0;
  }
  .hint {
    bottom: 22px;
  }
  @container ${lowHints} {
    .hint {
      bottom: 8px;
    }
  }
  @container ${notPhone} {
    :is(.draft-bar, .brush-bar, .hint:not(.bubble)) ~ .notices .notice {
      bottom: 70px;
    }
    .brush-bar:has(.words) ~ .notices .notice {
      bottom: 94px;
    }
  }
  @container ${notPhone} {
    .hint.suggests ~ .notices .notice {
      bottom: 78px;
    }
  }
  @container ${notPhone} {
    .notices .notice.aside,
    :is(.draft-bar, .brush-bar, .hint:not(.bubble)) ~ .notices .notice.aside {
      top: 16px;
      bottom: auto;
    }
  }
  @container ${phone} {
    .hint:not(.bubble) {
      bottom: 84px;
    }
    :is(.draft-bar, .brush-bar) {
      bottom: 78px;
    }
    .notice {
      top: 12px;
      bottom: auto;
    }
    .notice.aside {
      top: auto;
      bottom: 84px;
    }
    :is(.draft-bar, .brush-bar, .hint:not(.bubble)) ~ .notices .notice.aside {
      bottom: 134px;
    }
    .hint.suggests ~ .notices .notice.aside {
      bottom: 186px;
    }
    /* Clear of the sheet in every layout, and of each other. */
    .panel.open:not(.high) ~ :is(.hint:not(.bubble), .draft-bar, .brush-bar) {
      top: 12px;
      bottom: auto;
    }
    .panel.open:not(.high) ~ .notices .notice.aside {
      top: 12px;
      bottom: auto;
    }
    .panel.open:not(.high) ~ :is(.hint:not(.bubble), .draft-bar, .brush-bar) ~ .notices .notice {
      top: 72px;
      bottom: auto;
    }
    .panel.open:not(.high) ~ .hint.suggests ~ .notices .notice {
      top: 116px;
    }
    .panel.high ~ .notices .notice {
      top: auto;
      bottom: 84px;
    }
    .panel.high ~ .hint:not(.bubble) ~ .notices .notice {
      bottom: 134px;
    }
  }
  /* No tools below: hints, bar and notices move to the edge. */
  @container ${lowPhone} {
    .hint:not(.bubble),
    .draft-bar,
    .brush-bar {
      bottom: var(--_edge);
    }
    .notice {
      top: var(--_edge);
    }
    .panel.high ~ .notices .notice {
      bottom: var(--_edge);
    }
  }
`;
