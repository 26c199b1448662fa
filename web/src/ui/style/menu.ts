/** The menu of overlays. */
import { css } from 'lit';
import { phone } from './layouts';

export const menuStyle = css`
  .menu {
    position: relative;
  }
  .popover {
    position: fixed;
    inset: auto;
    margin: 0;
    padding: 6px;
    color: inherit;
  }
  .check {
    display: flex;
    align-items: center;
    gap: 9px;
    min-height: var(--_control);
    padding: 0 12px 0 8px;
    border-radius: var(--_radius-item);
    cursor: pointer;
  }
  .check:hover {
    background: var(--_raised);
  }
  .check input {
    width: 16px;
    height: 16px;
    margin: 0;
    accent-color: var(--_accent);
  }
  @container ${phone} {
    .popover {
      min-width: 200px;
    }
  }
`;
