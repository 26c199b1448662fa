/** The study card: it replaces the panel, or is a sheet above the tools on phones. */

import { FROM_BOTTOM } from '../../editor/sizes';
import { css } from '../style/css';
import { lowPhone, phone } from '../style/layouts';
import { ORDER } from '../style/order';

export const studyStyle = css`
  .study {
    position: absolute;
    z-index: ${ORDER.panel};
    inset-inline-end: var(--_edge);
    top: var(--_edge);
    width: calc(var(--_end) - 2 * var(--_edge));
    max-height: calc(100% - 2 * var(--_edge));
    display: flex;
    flex-direction: column;
    animation: appear var(--_speed);
  }
  .study header {
    flex: none;
    display: flex;
    align-items: center;
    gap: 6px;
    padding: 6px 8px;
    border-bottom: 1px solid var(--_line);
  }
  .study header .segments {
    flex: 1;
    flex-wrap: wrap;
    min-width: 0;
    margin: 0;
  }
  .study header .segment {
    flex: 1 1 auto;
    /* Five words share the width of the card, in two rows if they are long. */
    padding: 0 3px;
    font-size: 12px;
  }
  .study .page {
    overflow: auto;
    padding: 12px 14px 14px;
    overscroll-behavior: contain;
  }
  .study .page:focus-visible {
    outline-offset: -3px;
    border-radius: var(--_radius);
  }
  .study h3 {
    font-size: 13px;
  }
  .study p {
    font-size: 12px;
  }
  .study sub {
    font-size: inherit;
    line-height: 0;
  }
  .setting + .setting,
  .presets {
    margin-top: 12px;
    padding-top: 12px;
    border-top: 1px solid var(--_line);
  }
  .setting .control {
    display: flex;
    align-items: center;
    gap: 10px;
    margin: 6px 0;
  }
  .outlining {
    display: contents;
  }
  .setting .segments {
    flex: 1;
    margin: 0;
  }
  .setting .field {
    flex: 1;
    max-width: 150px;
  }
  .setting .slider ~ .field {
    flex: none;
    width: 84px;
  }
  .slider {
    flex: 1;
    min-width: 0;
    height: var(--_control);
    margin: 0;
    accent-color: var(--_accent);
  }
  .presets {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
  }
  .point {
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: 8px;
    min-height: var(--_control);
    margin-bottom: 4px;
  }
  .point h3 {
    font-variant-numeric: tabular-nums;
  }
  .point .faint {
    font-size: 12px;
  }
  .weights ul {
    margin: 0 -8px;
  }
  .row-of-bar {
    display: grid;
    grid-template: 'name track number' auto 'way way way' auto / minmax(0, 106px) 1fr 44px;
    align-items: center;
    column-gap: 8px;
    width: 100%;
    padding: 4px 8px;
    border: 0;
    border-radius: var(--_radius-item);
    background: none;
    color: inherit;
    font: inherit;
    font-size: 12px;
    text-align: start;
    cursor: pointer;
  }
  .row-of-bar:hover {
    background: var(--_raised);
  }
  .row-of-bar[aria-pressed='true'] {
    background: color-mix(in srgb, var(--_accent) 12%, transparent);
  }
  .row-of-bar .name {
    overflow: hidden;
    font-weight: 600;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .row-of-bar .name::first-letter {
    text-transform: uppercase;
  }
  .row-of-bar .number {
    text-align: end;
  }
  .row-of-bar .way {
    grid-area: way;
  }
  .row-of-bar:is(:hover, [aria-pressed='true']) .way {
    color: inherit;
  }
  .track {
    display: flex;
    height: 10px;
    border-radius: calc(0.3 * var(--_radius));
    background: var(--_raised);
    overflow: hidden;
  }
  .track .own,
  .swatch.own {
    background: var(--_accent);
  }
  :is(.track.of-virtual, .virtual ul) .own {
    background: var(--_virtual);
  }
  .track .passed,
  .swatch.passed {
    background: color-mix(in srgb, var(--_accent) 36%, var(--_surface));
  }
  .swatch {
    display: inline-block;
    width: 10px;
    height: 10px;
    margin-block: 0;
    margin-inline: 0 5px;
    border-radius: calc(0.3 * var(--_radius));
  }
  .key .meaning {
    display: inline-block;
    margin-inline-end: 10px;
  }
  .virtual summary {
    margin: 0 -8px;
    width: calc(100% + 16px);
    list-style: none;
  }
  .virtual summary::-webkit-details-marker {
    display: none;
  }
  .key {
    margin-top: 6px;
  }
  .falloff {
    margin-top: 12px;
    padding-top: 12px;
    border-top: 1px solid var(--_line);
  }
  .falloff .control {
    display: flex;
    align-items: center;
    gap: 10px;
  }
  .falloff .symbol {
    font-weight: 600;
  }
  .variants {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(150px, 1fr));
    gap: 14px;
    margin-top: 10px;
  }
  .variants figure {
    margin: 0;
  }
  .study .variant canvas {
    display: block;
    position: static;
    width: 100%;
    height: auto;
    aspect-ratio: 3 / 4;
    max-height: 46vh;
    border-radius: var(--_radius-item);
    background: repeating-conic-gradient(var(--_checker) 0 25%, var(--_ground) 0 50%) 0 0 / 16px 16px;
    transition: opacity var(--_speed);
  }
  .variant canvas.waiting {
    opacity: 0.45;
  }
  .variants figcaption {
    margin-top: 6px;
  }
  @container ${phone} {
    .study {
      inset-inline-start: var(--_edge);
      top: auto;
      bottom: ${FROM_BOTTOM.sheet}px;
      width: auto;
      max-height: 52%;
    }
  }
  @container ${lowPhone} {
    .study {
      inset-inline-start: var(--_start);
      bottom: var(--_edge);
      max-height: calc(100% - 2 * var(--_edge));
    }
  }
`;
