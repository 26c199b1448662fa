/**
 * Sizes for touch: targets of 44 px, and 16 px type in fields, since browsers zoom in on smaller type.
 *
 * The sizes depend on the pointer, not on the width. The sheet comes after those with sizes for a mouse.
 */

import { BARS, TOOLS } from '../../editor/sizes';
import { css } from './css';
import { low, lowest, lowestPhone, lowPhone, phone } from './layouts';

export const touchStyle = css`
  @media (pointer: coarse) {
    .top {
      height: ${BARS.coarse.toolbar}px;
    }
    .status {
      height: ${BARS.coarse.status}px;
    }
    .button,
    .button.small,
    .status .button {
      min-width: var(--_finger);
      height: var(--_finger);
    }
    .tools .button {
      width: 48px;
      height: 46px;
    }
    @container shell (width < 720px) {
      .brand {
        display: none;
      }
    }
    .segment {
      min-width: 0;
      height: var(--_finger);
    }
    .field {
      height: var(--_finger);
    }
    .field input,
    .naming .field input {
      font-size: 16px;
    }
    .field .unit {
      display: none;
    }
    .item,
    .check,
    .entry,
    .switch,
    .link,
    .bending summary,
    button.name {
      min-height: var(--_finger);
    }
    .link {
      padding: 0 10px;
    }
    .percent {
      font-size: 14px;
    }
    @container ${phone} {
      .status .caption {
        display: block;
      }
    }
    /* Four rows. */
    @container ${low} {
      .tools {
        gap: 0;
      }
    }
    @container ${lowest} {
      .middle {
        --_start: ${TOOLS.lowest.coarse}px;
      }
    }
    @container ${lowPhone} {
      .middle {
        --_start: ${TOOLS.lowPhone.coarse}px;
      }
    }
    @container ${lowestPhone} {
      .middle {
        --_start: ${TOOLS.lowestPhone.coarse}px;
      }
      .tools {
        grid-template-columns: auto auto auto;
      }
    }
  }
  /* Eight targets do not fit side by side here: they keep their height and divide the width equally. */
  @container shell (width < 360px) {
    .top {
      gap: 0;
    }
    .top .menu,
    .top .group > .button {
      flex: 1 1 0;
    }
    .tools {
      gap: 0;
    }
    .tools .button {
      flex: 0 1 48px;
      min-width: 0;
    }
  }
`;
