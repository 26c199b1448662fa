/** The list of handles. */
import { css } from './css';

export const handleListStyle = css`
  .list {
    display: flex;
    flex-direction: column;
  }
  .list .head {
    display: flex;
    align-items: center;
    justify-content: space-between;
    margin-block: -5px;
    margin-inline: 0 -7px;
  }
  .list ul {
    margin: 6px -6px -4px;
    /* Room for a scroll by a whole pixel. */
    padding-block: 1px;
    overflow: auto;
  }
  /* A long list scrolls on its own, and the numbers above it stay in view. */
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
    border: 0;
    border-radius: var(--_radius-item);
    background: none;
    color: inherit;
    font: inherit;
    text-align: start;
    cursor: pointer;
  }
  .item:hover {
    background: var(--_raised);
  }
  .item:focus-visible {
    outline-offset: -2px;
  }
  .item .name {
    display: -webkit-box;
    min-width: 0;
    overflow: hidden;
    overflow-wrap: anywhere;
    -webkit-box-orient: vertical;
    -webkit-line-clamp: 3;
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
    margin-inline-start: auto;
    width: 5px;
    height: 5px;
    border-radius: 50%;
    background: var(--_faint);
  }
`;
