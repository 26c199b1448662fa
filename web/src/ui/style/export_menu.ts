/** The export panel. */
import { css } from './css';
import { phone } from './layouts';

export const exportMenuStyle = css`
  .export {
    --_width: 320px;
    width: var(--_width);
    max-width: calc(100vw - 16px);
    max-height: calc(100dvh - 16px);
    padding: 12px;
    overflow: auto;
    box-sizing: border-box;
    white-space: normal;
  }
  /* As wide as elsewhere: the buttons of the bar around the panel are narrow. */
  .top .export .segment {
    flex: 1 1 0;
    width: auto;
  }
  /* The kinds of exports differ in length. */
  .top .export > .segments:first-child .segment {
    flex: 1 1 auto;
    padding-inline: 4px;
    white-space: nowrap;
  }
  .export:focus {
    outline: none;
  }
  .export > .faint {
    margin: 0 2px 10px;
    font-size: 12px;
  }
  .export .option {
    display: flex;
    align-items: center;
    gap: 10px;
    min-height: var(--_control);
    margin-bottom: 6px;
    font-size: 12px;
    font-weight: 600;
  }
  .export .option span {
    flex: none;
    min-width: 76px;
  }
  .export [type='range'] {
    flex: 1;
    min-width: 0;
    margin: 0;
    accent-color: var(--_accent);
  }
  .export output {
    min-width: 26px;
    text-align: end;
    font-variant-numeric: tabular-nums;
  }
  .export [type='color'] {
    width: 44px;
    height: 28px;
    padding: 2px;
    border: 1px solid var(--_bound);
    border-radius: var(--_radius-item);
    background: none;
  }
  .export .row {
    gap: 10px;
    margin: 12px 0 0;
    padding: 0;
  }
  .export .row .faint {
    display: block;
    min-width: 0;
    overflow-wrap: anywhere;
    font-variant-numeric: tabular-nums;
  }
  .export .primary {
    flex: none;
    height: var(--_control);
    padding: 0 16px;
  }
  .export .primary:disabled {
    opacity: 0.45;
  }
  @media (pointer: coarse) {
    .export .option,
    .export .primary {
      min-height: var(--_finger);
    }
    .export [type='range'],
    .export [type='color'] {
      height: var(--_finger);
    }
  }
  /* The place that the script sets is that of a menu. */
  @container ${phone} {
    .export {
      inset: auto 8px 8px !important;
      width: auto;
      max-width: none;
    }
  }
`;
