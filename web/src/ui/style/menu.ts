/** The menu of overlays. */
import { css } from 'lit';

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
    min-height: 34px;
    padding: 0 12px 0 8px;
    border-radius: 6px;
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
  @container shell (width < 640px) {
    .popover {
      min-width: 200px;
    }
  }
`;
