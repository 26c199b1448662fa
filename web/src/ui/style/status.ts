/** The status line. */

import { BARS } from '../../editor/sizes';
import { css } from './css';
import { narrow, phone } from './layouts';
import { ORDER } from './order';

export const statusStyle = css`
  .status {
    z-index: ${ORDER.status};
    gap: 16px;
    height: ${BARS.fine.status}px;
    padding-inline-start: 14px;
    border-top: 1px solid var(--_line);
    color: var(--_faint);
    font-size: 12px;
    white-space: nowrap;
  }
  .status .button {
    min-width: 28px;
    height: 28px;
    padding: 0 4px;
  }
  .status .icon {
    width: 16px;
    height: 16px;
  }
  .solved,
  .private,
  .view {
    display: flex;
    align-items: center;
    gap: 6px;
  }
  .solved {
    flex: 1;
    gap: 14px;
    min-width: 0;
    overflow: hidden;
  }
  .view {
    gap: 0;
  }
  .creased {
    display: flex;
    gap: 2px;
    min-width: 0;
  }
  .status .creased .button {
    color: var(--_warning);
    font-size: 12px;
    font-weight: 600;
  }
  .status .creased .shown {
    gap: 5px;
    min-width: 0;
    padding: 0 8px;
  }
  .status .creased [aria-pressed='true'] {
    background: color-mix(in srgb, var(--_warning) 12%, transparent);
    color: var(--_warning);
    box-shadow: inset 0 0 0 1.5px currentcolor;
  }
  /* Words below the icons need the height of a line for fingers. */
  .status .caption {
    display: none;
  }
  .percent {
    min-width: 46px;
    text-align: center;
    color: var(--_text);
  }
  @container shell (width < 1100px) {
    .status:has(.creased) .private {
      display: none;
    }
  }
  @container ${narrow} {
    .private,
    .solved .size {
      display: none;
    }
  }
  @container ${phone} {
    /* The notice and the menu have it, too. */
    .creased [data-command='without-folds'],
    .solved {
      display: none;
    }
    .status:has(.creased) {
      justify-content: space-between;
      gap: 0;
    }
    .status:has(.creased) .percent {
      display: none;
    }
    .creased .shown span {
      overflow: hidden;
      text-overflow: ellipsis;
    }
    .status {
      justify-content: center;
      padding: 0 8px;
    }
  }
`;
