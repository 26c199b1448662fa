/** The parts of the cards: panel, fields, menu, notices, progress. */
import { css } from 'lit';

export const chromeStyle = css`
  h2 {
    font-size: 14px;
    font-weight: 650;
    overflow-wrap: anywhere;
  }
  h2::first-letter {
    text-transform: uppercase;
  }
  h3 {
    font-size: 12px;
    font-weight: 600;
  }
  .fields {
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: 6px;
    margin: 10px 0 6px;
  }
  .field {
    position: relative;
    display: flex;
    align-items: center;
    height: 34px;
    padding: 0 7px;
    border: 1px solid transparent;
    border-radius: 7px;
    background: var(--_raised);
    cursor: text;
  }
  .field:focus-within {
    border-color: var(--_accent);
    background: var(--_surface);
  }
  .field .label,
  .field .unit {
    color: var(--_faint);
    font-size: 12px;
  }
  .field input {
    flex: 1;
    width: 0;
    min-width: 0;
    padding: 0 4px;
    border: 0;
    outline: none;
    background: none;
    color: inherit;
    font: inherit;
    text-align: right;
    appearance: textfield;
  }
  .field input::-webkit-inner-spin-button {
    display: none;
  }
  .fields > :nth-child(n + 3) {
    grid-column: 1 / -1;
  }
  .pair {
    display: flex;
    gap: 6px;
  }
  .pair .field {
    flex: 1;
  }
  .toggle,
  .segment {
    color: var(--_faint);
    font-size: 12px;
    font-weight: 550;
  }
  .toggle {
    padding: 0 11px;
    background: var(--_raised);
  }
  .button.toggle[aria-pressed='true'] {
    background: color-mix(in srgb, var(--_accent) 14%, transparent);
    color: var(--_accent);
  }
  .pair:has([aria-pressed='true']) input:not(:focus) {
    color: var(--_faint);
  }
  .segments {
    display: flex;
    gap: 2px;
    margin: 6px 0;
    padding: 2px;
    border-radius: 8px;
    background: var(--_raised);
  }
  .segment {
    flex: 1;
    height: 28px;
    border-radius: 6px;
  }
  .button.segment[aria-pressed='true'] {
    background: var(--_surface);
    color: var(--_text);
    box-shadow: 0 1px 2px light-dark(#0000002b, #0009);
  }
  .bending .faint {
    margin-bottom: 10px;
    font-size: 12px;
  }
  .switch {
    display: flex;
    align-items: center;
    gap: 10px;
    margin-top: 10px;
    padding-top: 10px;
    border-top: 1px solid var(--_line);
    cursor: pointer;
  }
  .switch + .switch {
    margin-top: 8px;
    padding-top: 0;
    border: 0;
  }
  .switch .text {
    flex: 1;
    font-weight: 600;
    font-size: 12px;
  }
  .switch .faint {
    display: block;
    margin: 0;
    font-weight: 400;
  }
  .switch input {
    appearance: none;
    position: relative;
    flex: none;
    width: 34px;
    height: 20px;
    margin: 0;
    border-radius: 10px;
    background: light-dark(#c9c9c6, #55585e);
    cursor: inherit;
    transition: background var(--_speed);
  }
  .switch input::before {
    content: '';
    position: absolute;
    inset: 2px auto 2px 2px;
    width: 16px;
    border-radius: 50%;
    background: #fff;
    box-shadow: 0 1px 2px #0005;
    transition: translate var(--_speed);
  }
  .switch input:checked {
    background: var(--_accent);
  }
  .switch input:checked::before {
    translate: 14px 0;
  }
  .switch:has(:disabled) {
    opacity: 0.45;
    cursor: default;
  }
  .row {
    display: flex;
    align-items: center;
    justify-content: flex-end;
    gap: 2px;
    margin: 0 -4px;
    padding-left: 4px;
  }
  .row .faint {
    flex: 1;
    font-size: 12px;
  }
  .properties + .list,
  .bending + .list {
    margin-top: 10px;
    padding-top: 12px;
    border-top: 1px solid var(--_line);
  }
  .list ul {
    margin: 6px -6px -4px;
  }
  .list p {
    margin-top: 6px;
  }
  .item {
    display: flex;
    align-items: center;
    gap: 8px;
    width: 100%;
    min-height: 30px;
    padding: 0 8px;
    border-radius: 6px;
    text-align: left;
  }
  .item .name {
    display: inline-block;
  }
  .item .name::first-letter {
    text-transform: uppercase;
  }
  .item .dot {
    width: 9px;
    height: 9px;
    border: 2px solid var(--_accent);
    border-radius: 50%;
  }
  .item .dot.of-bar {
    height: 0;
    width: 11px;
    border-width: 2px 0 0;
    border-radius: 1px;
    rotate: -35deg;
  }
  .item .dot.of-polygon {
    border-radius: 2px;
  }
  .item[aria-pressed='true'] {
    background: color-mix(in srgb, var(--_accent) 12%, transparent);
  }
  .item[aria-pressed='true'] .dot {
    background: var(--_accent);
  }
  .item .moved {
    margin-left: auto;
    width: 5px;
    height: 5px;
    border-radius: 50%;
    background: var(--_faint);
  }

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

  .hint,
  .notice {
    position: absolute;
    z-index: 2;
    left: 50%;
    translate: -50% 0;
  }
  .hint {
    bottom: 22px;
    padding: 9px 18px;
    border-radius: 20px;
    background: light-dark(#26272bee, #ececeaee);
    color: light-dark(#fff, #1e1f22);
    font-size: 14px;
    font-weight: 550;
    pointer-events: none;
    white-space: nowrap;
    animation: appear 400ms 500ms backwards;
  }
  .bubble {
    bottom: auto;
    translate: 26px -50%;
  }
  .bubble::before {
    content: '';
    position: absolute;
    top: calc(50% - 7px);
    right: 100%;
    border: 7px solid transparent;
    border-left: 0;
    border-right-color: light-dark(#26272bee, #ececeaee);
  }
  .draft-bar {
    position: absolute;
    z-index: 2;
    left: 50%;
    bottom: 16px;
    translate: -50% 0;
    display: flex;
    align-items: center;
    gap: 2px;
    padding: 4px 4px 4px 14px;
    white-space: nowrap;
    animation: appear var(--_speed);
  }
  .draft-bar .words {
    margin-right: 10px;
    color: var(--_faint);
  }
  .button.finish {
    padding: 0 12px 0 8px;
    background: var(--_accent);
    color: var(--_on-accent);
    font-weight: 600;
  }
  .button.finish:hover:not(:disabled) {
    background: color-mix(in srgb, var(--_accent) 88%, var(--_text));
  }
  .button.finish:disabled {
    background: var(--_raised);
    color: var(--_faint);
  }
  .notice {
    bottom: 16px;
    display: flex;
    align-items: center;
    gap: 8px;
    width: max-content;
    max-width: min(560px, calc(100% - 28px));
    padding: 8px 8px 8px 14px;
    border-left: 4px solid var(--_accent);
    overflow-wrap: anywhere;
    animation: appear var(--_speed);
  }
  .draft-bar ~ .notice {
    bottom: 70px;
  }
  .notice.error {
    border-left-color: var(--_danger);
  }
  .notice p {
    flex: 1;
  }

  .bar {
    position: absolute;
    z-index: 3;
    inset: 0 0 auto;
    height: 3px;
    overflow: hidden;
  }
  .bar::before {
    content: '';
    position: absolute;
    inset: 0;
    width: 35%;
    background: var(--_accent);
    animation: run 1.1s ease-in-out infinite;
  }
  @keyframes run {
    from {
      translate: -100% 0;
    }
    to {
      translate: 300% 0;
    }
  }
  .spinner {
    width: 12px;
    height: 12px;
    border: 2px solid var(--_line);
    border-top-color: var(--_accent);
    border-radius: 50%;
    animation: spin 0.8s linear infinite;
  }
  @keyframes spin {
    to {
      rotate: 1turn;
    }
  }
  @container shell (width < 640px) {
    .hint:not(.bubble) {
      bottom: 84px;
    }
    .draft-bar {
      bottom: 78px;
    }
    .button.finish {
      padding: 0 14px 0 10px;
    }
    .switch {
      min-height: 44px;
      padding-top: 6px;
      margin-top: 6px;
    }
    .switch + .switch {
      margin-top: 2px;
    }
    .segment {
      height: 44px;
    }
    .bending .faint {
      margin-bottom: 6px;
    }
    .notice {
      inset: 12px auto auto 50%;
    }
    .notice .button.small {
      min-width: 44px;
      height: 44px;
    }
    .bubble {
      translate: -75% calc(-100% - 28px);
    }
    .bubble::before {
      inset: 100% auto auto calc(75% - 7px);
      border: 7px solid transparent;
      border-bottom: 0;
      border-top-color: light-dark(#26272bee, #ececeaee);
    }
    .properties {
      display: grid;
      grid-template: 'name row' auto 'fields fields' auto / 1fr auto;
      align-items: center;
    }
    .fields {
      grid-area: fields;
      margin: 4px 0 0;
    }
    .fields {
      grid-template-columns: repeat(6, 1fr);
    }
    .fields > :nth-child(n) {
      grid-column: span 2;
    }
    .fields > .pair,
    .fields > .turn {
      grid-column: span 3;
    }
    .fields > .turn {
      order: 1;
    }
    .fields > .depth {
      order: 2;
    }
    .pair.turn {
      gap: 4px;
    }
    .pair.depth {
      gap: 0;
    }
    .field .unit,
    .row .faint {
      display: none;
    }
    .field input {
      font-size: 16px;
    }
    .field {
      height: 44px;
    }
    .popover {
      min-width: 200px;
    }
    .check {
      min-height: 44px;
    }
  }
`;
