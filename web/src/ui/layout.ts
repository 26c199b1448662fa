/** Where things stand: bars above and below, cards floating over the stage; on a phone the tools go below, the panel becomes a sheet. */
import { css } from 'lit';

export const layout = css`
  .shell {
    container: shell / size;
    position: absolute;
    inset: 0;
    display: grid;
    grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr);
  }
  .middle {
    position: relative;
    min-width: 0;
  }
  .top,
  .status {
    display: flex;
    align-items: center;
    background: var(--_surface);
    padding: 0 8px;
  }
  .top {
    z-index: 3;
    gap: 4px;
    height: 48px;
    border-bottom: 1px solid var(--_line);
  }
  .group {
    display: flex;
    gap: 2px;
  }
  .group + .group {
    padding-left: 6px;
    margin-left: 2px;
    border-left: 1px solid var(--_line);
  }
  .brand {
    padding: 0 12px 0 8px;
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
    min-width: 0;
    overflow: hidden;
    padding: 0 8px;
    color: var(--_faint);
    text-align: right;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .tools {
    position: absolute;
    z-index: 2;
    left: 12px;
    top: 12px;
    display: flex;
    flex-direction: column;
    gap: 2px;
    padding: 4px;
  }
  .tools .button {
    width: 40px;
    height: 40px;
  }
  .panel {
    position: absolute;
    z-index: 1;
    right: 12px;
    top: 12px;
    width: 224px;
    max-height: calc(100% - 24px);
    overflow: auto;
    padding: 12px;
  }
  .status {
    z-index: 2;
    gap: 16px;
    height: 34px;
    padding-left: 14px;
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
  .zoom {
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
  .zoom {
    gap: 0;
  }
  .status .folded {
    gap: 5px;
    padding: 0 8px;
    color: var(--_warning);
    font-size: 12px;
    font-weight: 600;
  }
  .status .folded[aria-pressed='true'] {
    background: color-mix(in srgb, var(--_warning) 16%, transparent);
    color: var(--_warning);
  }
  .sheet-switch {
    display: none;
  }
  .percent {
    min-width: 46px;
    text-align: center;
    color: var(--_text);
  }

  @container shell (width < 1100px) {
    .status:has(.folded) .private {
      display: none;
    }
  }
  @container shell (width < 900px) {
    .word,
    .private,
    .solved .size {
      display: none;
    }
    .button.worded {
      padding: 0 7px;
    }
  }

  /* A phone: tools within the thumb's reach, and everything 44 px. */
  @container shell (width < 640px) {
    .top {
      gap: 0;
      padding: 0 4px;
      height: 52px;
    }
    .group,
    .group + .group {
      gap: 0;
      margin: 0;
      padding: 0;
      border: 0;
    }
    .brand,
    .title,
    .solved {
      display: none;
    }
    .top .theme {
      display: none;
    }
    .top {
      justify-content: space-between;
    }
    .button {
      min-width: 44px;
      height: 44px;
      padding: 0;
    }
    .tools {
      position: absolute;
      top: auto;
      left: 50%;
      bottom: 10px;
      translate: -50% 0;
      flex-direction: row;
      gap: 4px;
    }
    .tools .button {
      width: 48px;
      height: 46px;
    }
    .sheet-switch {
      display: block;
      margin-left: 2px;
      padding-left: 4px;
      border-left: 1px solid var(--_line);
    }
    .status:has(.folded) {
      justify-content: space-between;
      gap: 0;
    }
    .status:has(.folded) .percent {
      display: none;
    }
    .panel {
      display: none;
      top: auto;
      right: 8px;
      left: 8px;
      bottom: 74px;
      width: auto;
      max-height: 46%;
      padding: 6px 10px 10px;
    }
    .panel.open {
      display: block;
    }
    .panel .list {
      display: none;
    }
    .status {
      justify-content: center;
      height: 46px;
      padding: 0 8px;
    }
    .status .button {
      min-width: 44px;
      height: 44px;
    }
    .percent {
      font-size: 14px;
    }
  }
  @media (pointer: coarse) {
    .top .button,
    .status .button,
    .row .button,
    .item {
      min-width: 44px;
      min-height: 44px;
    }
    .status {
      height: 46px;
    }
    .top {
      height: 52px;
    }
  }
`;
