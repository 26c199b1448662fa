/** Folds, cells, the cell graph and virtual sites. */
import { css } from 'lit';

export const overlaysStyle = css`
  /* Folded triangles have almost no width, so the stroke must show them. */
  .folds {
    fill: #f0250f;
    stroke: #f0250f;
    stroke-width: 2.5;
    stroke-linejoin: round;
  }
  .folds.pale {
    fill: none;
    stroke: #fffc;
    stroke-width: 6;
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
