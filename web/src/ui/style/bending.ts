/** The bending settings: one line that unfolds to segments and switches. */
import { css } from './css';
import { phone } from './layouts';

export const bendingStyle = css`
  .bending p {
    margin-bottom: 10px;
    font-size: 12px;
  }
  .bending summary {
    display: flex;
    align-items: center;
    gap: 6px;
    margin: -4px -6px;
    padding: 4px 6px;
    border-radius: var(--_radius-item);
    list-style: none;
    cursor: pointer;
  }
  .bending summary::-webkit-details-marker {
    display: none;
  }
  .bending summary .faint {
    flex: 1;
    font-size: 12px;
    text-align: end;
  }
  .bending summary .icon {
    width: 16px;
    height: 16px;
    color: var(--_faint);
  }
  .bending[open] summary .faint {
    visibility: hidden;
  }
  .bending[open] summary .icon {
    rotate: 180deg;
  }
  .all-settings {
    width: 100%;
    margin-top: 10px;
    background: var(--_raised);
  }
  @container ${phone} {
    .bending p {
      margin-bottom: 6px;
    }
    .bending summary {
      pointer-events: none;
    }
    .bending summary .icon {
      display: none;
    }
  }
`;
