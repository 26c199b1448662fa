/** Styles of saved figures, always in light colours. */
import { css } from '../style/css';

export const figuresStyle = css`
  .figure-to-save {
    position: absolute;
    visibility: hidden;
    color-scheme: light;
    pointer-events: none;
  }
  .figure-to-save .paper {
    fill: #fff;
  }
  .figure-to-save :is(.way, .glass, .aim) {
    fill: none;
    stroke: #2558e8;
    stroke-width: 1.5;
  }
  .figure-to-save .strong {
    font-weight: 600;
  }
  .figure-to-save .track {
    fill: var(--_raised);
  }
  .figure-to-save .weight.own {
    fill: var(--_accent);
  }
  .figure-to-save .weight.passed {
    fill: color-mix(in srgb, var(--_accent) 36%, var(--_surface));
  }
  .figure-to-save .weight.farthest {
    fill: #b3226b;
  }
  .figure-to-save .weight.nearest {
    fill: #1263ad;
  }
  .figure-to-save .weight.all-virtual {
    fill: #0b8a56;
  }
`;
