/** Creases, cells, the cell graph and virtual sites. */
import { css } from './css';

export const overlaysStyle = css`
  /* Folded triangles have almost no width, so the stroke must show them. */
  .creases {
    fill: #f0250f;
    stroke: #f0250f;
    stroke-width: 2.5;
    stroke-linejoin: round;
  }
  .creases.pale {
    fill: none;
    stroke: #fffc;
    stroke-width: 6;
  }
  .crease-place {
    stroke: #fff;
    stroke-width: 2;
    filter: drop-shadow(0 0 1.5px #f0250f) drop-shadow(0 0 1.5px #f0250f);
  }
  .crease-place circle {
    transform-box: fill-box;
    transform-origin: center;
    /* Users must be able to stop motion that lasts more than five seconds (WCAG 2.2.2). */
    animation: pulse 1.5s ease-out 3 both;
  }
  @keyframes pulse {
    from {
      scale: 0.35;
      opacity: 1;
    }
    to {
      scale: 1;
      opacity: 0;
    }
  }
  @media (prefers-reduced-motion: reduce) {
    .crease-place circle {
      animation: none;
    }
  }
  .outline {
    fill: none;
    stroke: #d1246f;
    stroke-width: 1.5;
    stroke-linecap: round;
  }
  .outline.pale {
    stroke: #fffc;
    stroke-width: 4;
  }
  .selection {
    fill: none;
    stroke: #26272bb3;
    stroke-width: 1;
    stroke-linecap: round;
  }
  .selection.pale {
    stroke: #fffa;
    stroke-width: 2.5;
  }
  .onion-skin {
    fill: none;
    stroke: #2558e8a0;
    stroke-width: 1.25;
    stroke-linecap: round;
  }
  .onion-skin.pale {
    stroke: #fff9;
    stroke-width: 3.5;
  }
  .cells {
    fill: none;
    stroke: #b3226b;
    stroke-width: 1.5;
    stroke-linecap: round;
  }
  .cells.pale {
    stroke: #fffa;
    stroke-width: 4;
  }
  .graph {
    stroke: #1263ad;
    stroke-width: 1.25;
  }
  .graph.pale {
    stroke: #fff8;
    stroke-width: 3;
  }
  .sites {
    stroke: #0b8a56;
    stroke-width: 7;
  }
  .sites.pale {
    stroke: var(--_casing);
    stroke-width: 10;
  }
`;
