/** The stage without a picture. */
import { css } from './css';

export const emptyStyle = css`
  .empty {
    position: absolute;
    inset: 0;
    display: grid;
    place-content: center;
    justify-items: center;
    gap: 14px;
    color: var(--_faint);
    font-size: 15px;
  }
  /* A picture that comes within a tenth of a second seems to be there at once, and needs no word. */
  .empty.opening {
    /* Presses are for the picture, and wait for it. */
    pointer-events: none;
    animation: appear var(--_speed) 100ms backwards;
  }
`;
