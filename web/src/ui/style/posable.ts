/** A posable picture in an article: as wide as its column, with the height of an image and no frame. */
import { css } from './css';

export const posableStyle = css`
  :host([posable]) {
    --_ground: var(--c2-ground, transparent);
    --_checker: var(--c2-checker, transparent);
    min-height: 0;
  }
  /* A press on a handle prevents scrolling by itself. */
  :host([posable]) .stage {
    touch-action: auto;
  }
  :host([posable]) .middle {
    --_start: 0px;
    --_end: 0px;
  }
  :host([posable]) .hint:not(.bubble) {
    bottom: 16px;
  }
`;
