/** The layout: bars above and below, cards over the stage; on a phone the tools go below, the panel becomes a sheet. */
import { css } from 'lit';

export const layout = css`
  .shell {
    container: shell / size;
    position: absolute;
    inset: 0;
    writing-mode: horizontal-tb;
    display: flex;
    flex-direction: column;
  }
  /* What the cards at both sides take of the width: what floats over the picture stands in the middle of the rest. */
  .middle {
    --_left: 84px;
    --_right: 260px;
    position: relative;
    flex: 1;
    min-height: 0;
  }
  .top,
  .status {
    flex: none;
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
    max-height: calc(100% - 24px);
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
    display: flex;
    flex-direction: column;
    overflow: auto;
    padding: 12px;
  }
  .panel > * {
    flex: none;
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
  .sheet-switch,
  .unfold {
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
    .middle {
      --_left: 72px;
      --_right: 248px;
    }
  }

  /* Low: the tools go side by side. */
  @container shell (width >= 640px) and (height < 372px) {
    .middle {
      --_left: 134px;
    }
    .tools {
      display: grid;
      grid-template-columns: auto auto;
    }
    .sheet-switch {
      display: none;
    }
  }
  @container shell (width >= 640px) and (height < 290px) {
    .middle {
      --_left: 182px;
    }
    .tools {
      grid-template-columns: auto auto auto;
    }
  }

  /* A phone: tools within the thumb's reach, and the panel a sheet above them. */
  @container shell (width < 640px) {
    .middle {
      --_left: 0px;
      --_right: 0px;
    }
    .top {
      gap: 0;
      justify-content: space-between;
      padding: 0 4px;
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
    .tools {
      position: absolute;
      top: auto;
      left: 50%;
      bottom: 10px;
      translate: -50% 0;
      flex-direction: row;
      gap: 4px;
      max-width: calc(100% - 16px);
    }
    .unfold {
      display: inline-flex;
    }
    .panel:not(.numbers) .unfold .icon {
      rotate: 180deg;
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
    .folded {
      min-width: 0;
    }
    .folded span {
      overflow: hidden;
      text-overflow: ellipsis;
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
    .panel.high {
      top: 8px;
      bottom: auto;
    }
    .panel.away {
      opacity: 0;
      pointer-events: none;
      transition: opacity var(--_speed) 100ms;
    }
    .panel .list,
    .panel.settings .properties,
    .panel:not(.numbers) :is(.fields, .corners),
    .panel:not(.settings) .bending {
      display: none;
    }
    .panel.settings .bending {
      margin: 0;
      padding: 0;
      border: 0;
    }
    .status {
      justify-content: center;
      padding: 0 8px;
    }
  }

  /* A low one: tools go to the left, as much side by side as it asks for, and the sheet lies beside them. */
  @container shell (width < 640px) and (height < 372px) {
    .middle {
      --_left: 108px;
    }
    .tools {
      left: 8px;
      top: 8px;
      bottom: auto;
      translate: none;
      display: grid;
      grid-template-columns: auto auto;
      gap: 2px;
      max-width: none;
      max-height: none;
    }
    .sheet-switch {
      margin: 0;
      padding: 0;
      border: 0;
    }
    .panel {
      left: var(--_left);
      bottom: 8px;
      max-height: calc(100% - 16px);
    }
  }
  @container shell (width < 400px) and (height < 372px) {
    .panel {
      z-index: 3;
      left: 8px;
    }
  }

  /* A keyboard on the glass leaves a strip: all of it is for what is typed. */
  @container shell (width < 640px) and (height < 460px) {
    .panel:has(.field :focus) {
      top: auto;
      bottom: 8px;
      max-height: calc(100% - 16px);
    }
    .tools:has(~ .panel .field :focus) {
      visibility: hidden;
    }
  }
`;
