/** The list of keys. */
import { css } from './css';

export const keysStyle = css`
  .keys {
    inset: 0;
    max-width: min(860px, calc(100vw - 24px));
    max-height: calc(100dvh - 24px);
    margin: auto;
    padding: 18px 22px 8px;
    overflow: auto;
    color: inherit;
  }
  .keys .columns {
    columns: 3 230px;
    column-gap: 32px;
  }
  .keys .button {
    position: sticky;
    z-index: 1;
    top: -10px;
    float: inline-end;
    margin-block: -8px 0;
    margin-inline: 0 -12px;
    background: var(--_surface);
  }
  .keys:focus {
    outline: none;
  }
  .keys section {
    break-inside: avoid;
    margin-bottom: 14px;
  }
  .keys dl {
    margin: 6px 0 0;
  }
  .keys dl div {
    display: flex;
    gap: 16px;
    justify-content: space-between;
    padding: 3px 0;
  }
  .keys dd {
    margin: 0;
    color: var(--_faint);
    white-space: nowrap;
  }
`;
