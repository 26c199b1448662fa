/** Notices, on a card. */
import { css } from './css';
import { phone } from './layouts';

export const noticeStyle = css`
  .notices {
    display: contents;
  }
  .notice {
    display: flex;
    align-items: center;
    gap: 8px;
    max-width: min(560px, var(--_free));
    padding-block: 8px;
    padding-inline: 14px 8px;
    border-inline-start: 4px solid var(--_accent);
    overflow-wrap: anywhere;
    animation: appear var(--_speed);
    transition: opacity var(--_speed);
  }
  .notice.away {
    opacity: 0.15;
    pointer-events: none;
  }
  .notice.error {
    border-inline-start-color: var(--_danger);
  }
  /* Keeps words whole beside a long action. Percentages do not count toward the width of the card, these units do. */
  .notice p {
    flex: 1;
    min-width: min(9em, 30cqw);
  }
  .notice .link {
    min-width: 0;
    white-space: normal;
    text-align: start;
  }
  /* Two answers have a row of their own where they do not fit. */
  .notice:has(.link ~ .link) {
    flex-wrap: wrap;
    row-gap: 4px;
  }
  .notice:has(.link ~ .link) p {
    flex: 1 0 12em;
  }
  @container ${phone} {
    .notice:has(.link ~ .link) p {
      flex: 1 0 calc(100% - 60px);
    }
    .notice:has(.link ~ .link) .link {
      order: 1;
      margin-inline-end: 8px;
    }
  }
`;
