/** The toolbar: groups of buttons, and the name of the picture. */

import { BARS } from '../../editor/sizes';
import { css } from './css';
import { narrow, phone } from './layouts';
import { ORDER } from './order';

export const toolbarStyle = css`
  .top {
    z-index: ${ORDER.toolbar};
    gap: 4px;
    height: ${BARS.fine.toolbar}px;
    border-bottom: 1px solid var(--_line);
  }
  .group {
    display: flex;
    gap: 2px;
  }
  .group + .group {
    padding-inline-start: 6px;
    margin-inline-start: 2px;
    border-inline-start: 1px solid var(--_line);
  }
  .brand {
    padding-block: 0;
    padding-inline: 8px 12px;
    font-size: 16px;
    font-weight: 700;
    letter-spacing: -0.02em;
  }
  .brand sup {
    color: var(--_accent);
    font-size: 0.68em;
    line-height: 0;
  }
  .title {
    flex: 1;
    display: flex;
    justify-content: flex-end;
    align-items: baseline;
    gap: 8px;
    min-width: 0;
    padding: 0 8px;
    color: var(--_faint);
    white-space: nowrap;
  }
  .title > * {
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .title .name {
    min-width: 3em;
  }
  .title .kept {
    flex: 0 100 auto;
    min-width: 0;
    font-size: 12px;
  }
  /* The mark of unsaved changes: beside the name, and on phones at the button that saves. */
  .title.unsaved .name::before {
    content: '';
    display: inline-block;
    width: 7px;
    height: 7px;
    margin-inline-end: 7px;
    border-radius: 50%;
    background: var(--_accent);
    vertical-align: 1px;
  }
  @container ${narrow} {
    .word {
      display: none;
    }
    .button.worded {
      padding: 0 7px;
    }
  }
  @container ${phone} {
    .top {
      gap: 0;
      justify-content: space-between;
      padding: 0 4px;
    }
    /* One row of buttons of equal width. */
    .group {
      display: contents;
    }
    .top .menu,
    .top .group > .button,
    .top > .button,
    .top .menu > .button {
      flex: 0 1 44px;
      min-width: 0;
      padding: 0;
    }
    .top .menu > .button {
      width: 100%;
    }
    .top:has(.title.unsaved) [data-command='save']::after {
      content: '';
      position: absolute;
      top: 9px;
      inset-inline-end: calc(50% - 14px);
      width: 7px;
      height: 7px;
      border-radius: 50%;
      background: var(--_accent);
    }
    .brand,
    .title,
    .keys-button,
    .top .theme,
    .top .group > :is([data-command='open'], [data-command='reset-all'], [data-command='timeline']) {
      display: none;
    }
  }
`;
