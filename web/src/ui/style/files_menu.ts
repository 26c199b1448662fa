/** The menu beside Open. */
import { css } from './css';
import { phone } from './layouts';

export const filesMenuStyle = css`
  .files {
    --_width: 300;
    width: min(300px, calc(100vw - 12px));
    padding: 12px;
  }
  .files h2 {
    display: flex;
    align-items: center;
    justify-content: space-between;
    min-height: 28px;
    margin: 0 0 4px;
  }
  .files section {
    margin-top: 10px;
  }
  .files p {
    margin: 0;
  }
  .files .address {
    display: flex;
    gap: 6px;
  }
  .files .address input {
    flex: 1;
    min-width: 0;
    height: var(--_control);
    padding: 0 10px;
    border: 1px solid var(--_bound);
    border-radius: var(--_radius-control);
    background: var(--_surface);
    color: inherit;
    font: inherit;
  }
  .files .address .button {
    padding: 0 12px;
    background: var(--_raised);
    font-weight: 600;
  }
  .files .samples {
    display: grid;
    grid-template-columns: repeat(3, 1fr);
    gap: 4px;
    margin: 0 -6px;
  }
  .files .samples .button {
    flex-direction: column;
    height: auto;
    padding: 6px 2px;
    gap: 4px;
    font-size: 12px;
  }
  .files .samples img {
    width: 72px;
    height: 72px;
  }
  .files ul {
    margin: 0 -6px;
    padding: 0;
    list-style: none;
  }
  .files li {
    display: flex;
    align-items: center;
    border-radius: var(--_radius-item);
  }
  .files .pick {
    flex: 1;
    min-width: 0;
    height: auto;
    padding: 4px 6px;
    gap: 10px;
    justify-content: flex-start;
  }
  .files .name {
    flex: 1;
    min-width: 0;
    overflow: hidden;
    text-align: start;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .files .pick .faint {
    font-size: 12px;
  }
  .files :is(img, .no-thumbnail) {
    flex: none;
    width: 40px;
    height: 40px;
    object-fit: contain;
    border-radius: calc(0.4 * var(--_radius));
    background: var(--_ground);
  }
  .files [data-command='open'],
  .button.slim .icon + .icon {
    display: none;
  }
  .button.slim {
    min-width: 22px;
    padding: 0 3px;
    margin-inline-start: -4px;
  }
  @media (pointer: coarse) {
    .files .address input {
      height: var(--_finger);
      font-size: 16px;
    }
    .button.slim {
      min-width: var(--_finger);
      margin-inline-start: 0;
    }
  }
  @container ${phone} {
    .button.slim {
      margin-inline-start: 0;
    }
    .button.slim .icon:first-child {
      display: none;
    }
    .button.slim .icon + .icon {
      display: block;
    }
    .files [data-command='open'] {
      display: flex;
      width: 100%;
      margin-bottom: 8px;
      background: var(--_raised);
      font-weight: 600;
    }
  }
`;
