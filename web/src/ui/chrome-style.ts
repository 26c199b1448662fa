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
    background: light-dark(var(--_surface), color-mix(in srgb, var(--_raised), #fff 17%));
    color: var(--_text);
    box-shadow: 0 1px 2px light-dark(#0000002b, #0009);
  }
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
    border-radius: 6px;
    list-style: none;
    cursor: pointer;
  }
  .bending summary::-webkit-details-marker {
    display: none;
  }
  .bending summary .faint {
    flex: 1;
    overflow: hidden;
    font-size: 12px;
    text-align: right;
    text-overflow: ellipsis;
    white-space: nowrap;
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
    background: color-mix(in srgb, var(--_text) 24%, var(--_surface));
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
  .properties + :is(.bending, .list),
  .bending + .list {
    margin-top: 10px;
    padding-top: 12px;
    border-top: 1px solid var(--_line);
  }
  /* A long list scrolls by itself: the numbers above it stay. */
  .list {
    display: flex;
    flex-direction: column;
  }
  .list ul {
    margin: 6px -6px -4px;
    overflow: auto;
  }
  .panel > .list:has(li:nth-child(4)) {
    flex: 0 1 auto;
    min-height: 150px;
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
  .item:focus-visible {
    outline-offset: -2px;
  }
  .item .name {
    display: inline-block;
    min-width: 0;
    overflow-wrap: anywhere;
  }
  .item .name::first-letter {
    text-transform: uppercase;
  }
  .item .dot,
  .item .moved {
    flex: none;
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
  .draft-bar,
  .notice {
    --_free: calc(100% - var(--_left) - var(--_right) - 16px);
    position: absolute;
    z-index: 2;
    left: calc((100% + var(--_left) - var(--_right)) / 2);
    width: max-content;
    max-width: var(--_free);
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
    text-align: center;
    pointer-events: none;
    animation: appear 400ms 500ms backwards;
  }
  .legend {
    display: flex;
    align-items: center;
    gap: 10px;
    padding: 7px 16px;
    font-size: 12px;
    white-space: nowrap;
    animation: appear var(--_speed);
  }
  /* It stays as long as something is selected: where there is no room beside the picture, that can be seen instead. */
  @container shell (height < 440px) {
    .legend {
      display: none;
    }
  }
  .ramp {
    width: 120px;
    height: 10px;
    border-radius: 5px;
    background-color: #b9b5b0;
  }
  /* The half, as its isoline. */
  .ramp::before {
    content: '';
    display: block;
    width: 2px;
    height: 100%;
    margin: auto;
    background: #080d29d9;
  }
  /* It belongs to the picture: under the cards. */
  .bubble {
    bottom: auto;
    z-index: auto;
    white-space: nowrap;
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
  .bubble.above {
    translate: -75% calc(-100% - 28px);
  }
  .bubble.above::before {
    inset: 100% auto auto calc(75% - 7px);
    border: 7px solid transparent;
    border-bottom: 0;
    border-top-color: light-dark(#26272bee, #ececeaee);
  }
  .draft-bar {
    bottom: 16px;
    display: flex;
    align-items: center;
    gap: 2px;
    padding: 4px 4px 4px 14px;
    animation: appear var(--_speed);
  }
  .draft-bar .words {
    min-width: 0;
    margin-right: 10px;
    line-height: 1.25;
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
    max-width: min(560px, var(--_free));
    padding: 8px 8px 8px 14px;
    border-left: 4px solid var(--_accent);
    overflow-wrap: anywhere;
    animation: appear var(--_speed);
  }
  .notice.error {
    border-left-color: var(--_danger);
  }
  .notice p {
    flex: 1;
  }
  .notice .link {
    min-width: 0;
    white-space: normal;
    text-align: left;
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
  @container shell (width >= 640px) {
    :is(.draft-bar, .hint:not(.bubble)) ~ .notice {
      bottom: 70px;
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
      padding-top: 6px;
      margin-top: 6px;
    }
    .switch + .switch {
      margin-top: 2px;
    }
    .bending p {
      margin-bottom: 6px;
    }
    .bending summary {
      pointer-events: none;
    }
    .bending summary .icon {
      display: none;
    }
    .notice {
      top: 12px;
      bottom: auto;
    }
    /* Clear of the sheet, wherever it is, and of one another. */
    .panel.open:not(.high) ~ :is(.hint:not(.bubble), .draft-bar) {
      top: 12px;
      bottom: auto;
    }
    .panel.open:not(.high) ~ :is(.hint:not(.bubble), .draft-bar) ~ .notice {
      top: 72px;
    }
    .panel.high ~ .notice {
      top: auto;
      bottom: 84px;
    }
    .panel.high ~ .hint:not(.bubble) ~ .notice {
      bottom: 134px;
    }
    .properties {
      display: grid;
      grid-template: 'name corners row' auto 'fields fields fields' auto / 1fr auto auto;
      align-items: center;
    }
    .row {
      grid-area: row;
      margin-left: 0;
      padding: 0;
    }
    .row.corners {
      grid-area: corners;
      margin: 0;
    }
    /* As wide as their numbers ask for; where two do not fit on a line, one goes to the next. */
    .fields {
      grid-area: fields;
      display: flex;
      flex-wrap: wrap;
      margin: 4px 0 0;
    }
    .fields > :nth-child(n) {
      flex: 1 1 28%;
    }
    .fields > :nth-child(n).turn {
      order: 1;
      flex-basis: 41%;
      min-width: 132px;
    }
    .fields > :nth-child(n).depth {
      order: 2;
      flex-basis: 51%;
      min-width: 174px;
    }
    .field {
      padding: 0 6px;
    }
    .field input {
      padding: 0 0 0 3px;
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
    .popover {
      min-width: 200px;
    }
  }
  /* No tools below: what is said and drawn goes to the edge. */
  @container shell (width < 640px) and (height < 372px) {
    .hint:not(.bubble),
    .draft-bar {
      bottom: 8px;
    }
    .hint:not(.bubble) {
      padding: 6px 12px;
      font-size: 13px;
    }
    .notice {
      top: 8px;
    }
    .panel.high ~ .notice {
      bottom: 8px;
    }
  }
`;
