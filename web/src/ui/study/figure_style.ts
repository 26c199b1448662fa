/** The figures of the study card: axes, curves, radii, maps; and the marks of the lens on the stage. */
import { css } from '../style/css';

export const figureStyle = css`
  .figure {
    display: block;
    width: 100%;
    height: auto;
    font-size: 12px;
    overflow: visible;
  }
  .figure .axis {
    fill: none;
    stroke: var(--_bound);
  }
  .figure text {
    fill: var(--_text);
  }
  .figure .tick {
    fill: var(--_faint);
  }
  .figure .index {
    font-size: 12px;
  }
  .area {
    fill: color-mix(in srgb, var(--_accent) 12%, transparent);
  }
  .curve {
    fill: none;
    stroke: var(--_accent);
    stroke-width: 2;
  }
  .at {
    stroke: var(--_text);
    stroke-dasharray: 2 3;
  }
  .at-dot {
    fill: var(--_text);
  }
  .radius {
    stroke: var(--_faint);
    stroke-dasharray: 4 3;
  }
  .radius.support {
    stroke: var(--_accent);
    stroke-dasharray: none;
  }
  .radius.cell-radius {
    stroke: var(--_farthest);
  }
  .radius.separation {
    stroke: var(--_nearest);
  }
  .figure .radius-name.support {
    fill: var(--_accent);
  }
  .figure .radius-name.cell-radius {
    fill: var(--_farthest);
  }
  .figure .radius-name.separation {
    fill: var(--_nearest);
  }
  .grip {
    fill: var(--_surface);
    stroke: var(--_accent);
    stroke-width: 2.5;
    cursor: ew-resize;
    touch-action: none;
  }
  .figure .shape {
    fill: color-mix(in srgb, var(--_text) 7%, var(--_surface));
    stroke: var(--_bound);
  }
  .figure .dot.virtual {
    fill: var(--_virtual);
  }
  .figure .dot.real {
    fill: var(--_accent);
    stroke: var(--_surface);
    stroke-width: 1.5;
  }
  .figure .border {
    fill: none;
    stroke: color-mix(in srgb, var(--_text) 40%, var(--_surface));
  }
  .figure .radius.on-map {
    fill: none;
    stroke-width: 1.25;
    stroke-dasharray: none;
  }
  .figure .allowed {
    fill: color-mix(in srgb, var(--_accent) 9%, transparent);
    stroke: var(--_accent);
    stroke-dasharray: 3 3;
  }
  .figure .entering {
    fill: none;
    stroke: var(--_farthest);
    stroke-width: 2;
  }
  .figure .limit {
    stroke: var(--_faint);
    stroke-dasharray: 4 3;
  }
  .map {
    overflow: hidden;
  }
  .round-words {
    min-height: 51px;
    margin: 4px 0;
  }
  .player {
    display: flex;
    align-items: center;
    gap: 4px;
    margin-bottom: 8px;
  }
  .player .number {
    min-width: 56px;
    text-align: end;
    white-space: nowrap;
  }
  .save-figure {
    gap: 6px;
    margin-top: 10px;
    padding-inline-start: 8px;
  }
  .swatch.of-farthest {
    background: var(--_farthest);
  }
  .swatch.of-nearest {
    background: var(--_nearest);
  }
  .times-title {
    margin-top: 12px;
    padding-top: 12px;
    border-top: 1px solid var(--_line);
  }
  .times {
    margin: 6px 0 0;
    font-size: 12px;
  }
  .times div {
    display: flex;
    justify-content: space-between;
  }
  .times dd {
    margin: 0;
  }
  .cell-border {
    fill: none;
    stroke: #fffb;
    stroke-width: 1.25;
  }
  .radii path {
    fill: none;
    stroke-width: 2;
    stroke-linecap: round;
  }
  .radii .pale {
    stroke: #fffc;
    stroke-width: 4.5;
  }
  .radii .of-farthest {
    stroke: #b3226b;
  }
  .radii .of-nearest {
    stroke: #1263ad;
  }
  .round .inserted {
    fill: #0b8a56;
    stroke: #fff;
    stroke-width: 1.5;
  }
  .round :is(.way, .entering) {
    fill: none;
    stroke: #b3226b;
    stroke-width: 2;
  }
  .round :is(.way, .entering).pale {
    stroke: #fffc;
    stroke-width: 4.5;
  }
  .lens .way {
    fill: none;
    stroke: #2558e8;
    stroke-width: 1.75;
    stroke-dasharray: 1 5;
    stroke-linecap: round;
  }
  .lens .way.pale {
    stroke: #fffc;
    stroke-width: 4.5;
    stroke-dasharray: none;
  }
  .lens .way.chosen {
    stroke-width: 2.5;
    stroke-dasharray: none;
  }
  .lens .passing {
    fill: #0b8a56a0;
    stroke: #fff;
    stroke-width: 1.5;
  }
  .lens .passing.chosen {
    fill: #0b8a56;
  }
  .glass,
  .aim {
    fill: none;
    stroke: #1e1f22;
    stroke-width: 1.75;
  }
  .glass.pale,
  .aim.pale {
    stroke: #fff;
    stroke-width: 4.5;
  }
`;
