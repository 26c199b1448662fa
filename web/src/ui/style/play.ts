/** A picture that plays in an article: as wide as its column, as high as an image, and directly on the page. */
import { css } from 'lit';

export const playStyle = css`
  :host([play]) {
    --_ground: var(--c2-ground, transparent);
    --_checker: var(--c2-checker, transparent);
    min-height: 0;
  }
  /* What takes hold of a handle keeps the page still by itself. */
  :host([play]) .stage {
    touch-action: auto;
  }
  :host([play]) .middle {
    --_left: 0px;
    --_right: 0px;
  }
  :host([play]) .hint:not(.bubble) {
    bottom: 16px;
  }
`;
