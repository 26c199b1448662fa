/** The shape with its sites, drawn at rest or posed: the ground of several figures. */
import { type SVGTemplateResult, svg } from 'lit-html';
import type { Vec } from '../../geometry/vec';
import { least, most, pathOf } from './figure';

/** The place of the picture in a figure. */
export interface MapFrame {
  readonly scale: number;
  readonly place: (at: Vec) => Vec;
  readonly width: number;
  readonly height: number;
}

/** Room around the shape for marks, in units of the figure. */
const RIM = 10;

/** The frame that just holds `points` of the picture, at most this wide and high. */
export function mapFrame(points: readonly Vec[], width: number, mostHeight: number): MapFrame {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  const [left, top] = [least(xs), least(ys)];
  const [w, h] = [most(xs) - left || 1, most(ys) - top || 1];
  const scale = Math.min((width - 2 * RIM) / w, (mostHeight - 2 * RIM) / h);
  const indent = (width - w * scale) / 2;
  return {
    scale,
    place: ([x, y]) => [indent + (x - left) * scale, RIM + (y - top) * scale],
    width,
    height: h * scale + 2 * RIM,
  };
}

export const shape = (rings: readonly (readonly Vec[])[], { place }: MapFrame): SVGTemplateResult =>
  svg`<path class="shape" fill-rule="evenodd" d=${rings.map((ring) => pathOf(ring.map(place), true)).join('')}/>`;

/** A dot for each site: real ones with a casing. @param handles as in `SiteStudy.handle`. */
export const siteDots = (places: readonly Vec[], handles: readonly number[]): SVGTemplateResult => svg`
  ${places.map(([x, y], site) => {
    const real = handles[site] !== -1;
    return svg`<circle class="dot ${real ? 'real' : 'virtual'}" cx=${x.toFixed(1)} cy=${y.toFixed(1)} r=${real ? 4.5 : 3}/>`;
  })}`;
