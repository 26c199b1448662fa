/** The falloff φ(d / r) of one site (eq. 5), with its radii. A drag of the end r changes α. */

import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from 'lit-html';
import type { Project } from '../../document/project';
import { settingsOf } from '../../document/settings';
import type { Dispatch } from '../../editor/events';
import type { Falloff } from '../../editor/lens_model';
import { siteName } from '../../editor/lens_words';
import type { EditorModel } from '../../editor/view_model';
import { ticks } from '../../geometry/ticks';
import type { Vec } from '../../geometry/vec';
import type { Texts } from '../../texts/texts';
import { worded } from '../../texts/wording';
import { axes, numberAtX, type Plot, pathOf, pixels, plotX, plotY } from './figure';
import { alphaSlider } from './slider';
import { withSymbols } from './symbols';

const SIZE = { width: 294, height: 190 } as const;

export function falloffPart(
  falloff: Falloff,
  project: Project,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const alpha = settingsOf(model.document.project).shape_factor;
  const { lens: words } = model.texts;
  return html`<section class="falloff" aria-label=${words.falloff}>
    <h3>${falloffTitle(falloff, project, model.texts)}</h3>
    ${
      falloff.site.support_radius === null
        ? html`<p class="faint">${words.noEnd}</p>`
        : html`<svg
            class="figure"
            viewBox="0 0 ${SIZE.width} ${SIZE.height}"
            role="img"
            aria-label=${label(falloff, falloff.site.support_radius, words)}
          >
            ${falloffChart(falloff, falloff.site.support_radius, words)}
            ${grip(falloff, falloff.site.support_radius, model, dispatch)}
          </svg>`
    }
    <div class="control">
      <span class="symbol">α</span>${alphaSlider(alpha, model, dispatch)}<span class="number">${alpha.toFixed(2)}</span>
    </div>
    <p class="faint">${radii(falloff, words)}</p>
  </section>`;
}

export const falloffTitle = ({ site, index }: Falloff, project: Project, texts: Texts): string =>
  texts.lens.falloffOf(
    site.handle === -1 ? texts.names.virtualHandle(index + 1) : worded(texts, siteName(project, site.handle)),
  );

const label = ({ curve, distance }: Falloff, radius: number, words: Texts['lens']): string =>
  words.falloffLabel(valueAt(curve, distance / radius).toFixed(2), pixels(distance), pixels(radius));

const radii = (
  { site: { cell_radius, separation, support_radius } }: Falloff,
  words: Texts['lens'],
): readonly (string | TemplateResult)[] =>
  withSymbols(
    words.radii(
      pixels(cell_radius),
      separation === null ? null : pixels(separation),
      support_radius === null ? null : pixels(support_radius),
    ),
  );

/** The part of the figure that the curve is drawn in. */
function plotOf({ site }: Falloff, radius: number): Plot {
  const most = 1.15 * Math.max(radius, site.support_range[1] ?? 0, site.cell_radius, site.separation ?? 0);
  const { width, height } = SIZE;
  return { left: 30, right: width - 8, top: 12, bottom: height - 40, x: [0, most], y: [0, 1] };
}

/** The figure without its grip. */
export function falloffChart(falloff: Falloff, radius: number, words: Texts['lens']): SVGTemplateResult {
  const { site, distance, curve } = falloff;
  const plot = plotOf(falloff, radius);
  const places = curve.map(
    (phi, at): Vec => [plotX(plot, (radius * at) / (curve.length - 1)), plotY(plot, phi)],
  );
  const x = plotX(plot, radius);
  return svg`${axes(plot, ticks(plot.x, 4), [0, 0.5, 1])}
    <text class="tick" text-anchor="end" x=${plot.right} y=${SIZE.height - 6}>${words.distanceAxis}</text>
    <path class="area" d="${pathOf([...places, [plot.left, plot.bottom]], true)}"/>
    <path class="curve" d=${pathOf([...places, [plot.right, plot.bottom]])}/>
    ${mark(plot, site.cell_radius, 'd', 'cell-radius', 0)}
    ${site.separation === null ? nothing : mark(plot, site.separation, 'h', 'separation', 1)}
    <path class="radius support" d="M${x} ${plot.top}V${plot.bottom}"/>
    <text class="radius-name support" x=${x + 5} y=${plot.top + 46}>r</text>
    ${distance > plot.x[1] ? beyond(plot, distance, words) : place(plot, distance, valueAt(curve, distance / radius))}`;
}

/** The point under the lens on the curve. */
function place(plot: Plot, distance: number, value: number): SVGTemplateResult {
  const [x, y] = [plotX(plot, distance), plotY(plot, value)];
  return svg`<path class="at" d="M${x} ${plot.bottom}V${y}"/><circle class="at-dot" cx=${x} cy=${y} r="4.5"/>`;
}

/** The point under the lens, farther away than the figure reaches. */
const beyond = (plot: Plot, distance: number, words: Texts['lens']): SVGTemplateResult =>
  svg`<text text-anchor="end" x=${plot.right} y=${plot.bottom - 10}>${words.thisPoint(pixels(distance))}</text>`;

const mark = (plot: Plot, at: number, index: string, kind: string, line: number): SVGTemplateResult => {
  const x = plotX(plot, at);
  return svg`<path class="radius ${kind}" d="M${x} ${plot.top}V${plot.bottom}"/>
    <text class="radius-name ${kind}" text-anchor=${line === 0 ? 'end' : 'start'} x=${line === 0 ? x - 5 : x + 5} y=${plot.top + 10 + 18 * line}>r<tspan dy="3">${index}</tspan></text>`;
};

/** φ at t, between the steps that it is drawn with. */
function valueAt(curve: readonly number[], t: number): number {
  const at = Math.min(t, 1) * (curve.length - 1);
  const [low, high] = [Math.floor(at), Math.ceil(at)];
  const [from = 0, to = 0] = [curve[low], curve[high]];
  return from + (to - from) * (at - low);
}

/** The end of the support, to be dragged. Keys use the slider of α. */
function grip(
  falloff: Falloff,
  radius: number,
  model: EditorModel,
  dispatch: Dispatch,
): SVGTemplateResult | typeof nothing {
  const [least, most] = falloff.site.support_range;
  if (model.readonly || least === undefined || most === undefined || most - least < 1e-6) return nothing;
  const plot = plotOf(falloff, radius);
  const set = (event: PointerEvent, type: 'setting-slid' | 'setting-set') => {
    const held = event.currentTarget as SVGElement;
    const figure = held.ownerSVGElement;
    if (!figure || !held.hasPointerCapture(event.pointerId)) return;
    const { left, width } = figure.getBoundingClientRect();
    const to = numberAtX(plot, ((event.clientX - left) * SIZE.width) / width);
    const alpha = Math.min(Math.max((to - least) / (most - least), 0), 1);
    dispatch({ type, setting: { name: 'shape_factor', value: Number(alpha.toFixed(2)) } });
  };
  return svg`<circle
    class="grip" cx=${plotX(plot, radius)} cy=${plot.bottom} r="8"
    @pointerdown=${(event: PointerEvent) => (event.currentTarget as Element).setPointerCapture(event.pointerId)}
    @pointermove=${(event: PointerEvent) => set(event, 'setting-slid')}
    @pointerup=${(event: PointerEvent) => set(event, 'setting-set')}
  />`;
}
