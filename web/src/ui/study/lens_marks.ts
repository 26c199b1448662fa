/** The lens on the stage: the point under it, the shortest path to each handle, and the virtual sites that move it. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import { type LensModel, lensModel } from '../../editor/lens_model';
import type { EditorModel } from '../../editor/view_model';
import { toStage } from '../../geometry/camera';
import type { Vec } from '../../geometry/vec';
import { pathOf } from './figure';

/** Length of the pieces of a bent path, image pixels at rest. */
const STEP = 12;
/** Radius of a site's dot, CSS pixels, for no weight and for all of it. Its area grows with the weight. */
const DOT = { none: 2.5, all: 15 } as const;

export function lensMarks(model: EditorModel): SVGTemplateResult | typeof nothing {
  const { camera, study } = model;
  if (study.page !== 'lens' || !study.lens.at || model.preview) return nothing;
  const shown = lensModel(study);
  const place = (line: readonly Vec[]) => line.map((vertex) => toStage(camera, vertex));
  const [at] = model.posedLines([[study.lens.at]], STEP).flatMap(place);
  if (!at) return nothing;
  return svg`<g class="lens">
    ${shown ? explained(shown, model, place) : nothing}
    <g transform="translate(${at[0]} ${at[1]})">
      <circle class="glass pale" r="15"/><circle class="glass" r="15"/>
      <path class="aim pale" d="M-5 0H5M0 -5V5"/><path class="aim" d="M-5 0H5M0 -5V5"/>
    </g>
  </g>`;
}

function explained(
  { lens: { shares, sites }, study, falloff }: LensModel,
  model: EditorModel,
  place: (line: readonly Vec[]) => readonly Vec[],
): SVGTemplateResult {
  const posed = (lines: readonly (readonly Vec[])[]) => model.posedLines(lines, STEP).map(place);
  const ways = posed(shares.map(({ path }) => path)).map((line) => pathOf(line));
  const virtual = sites.flatMap(({ site, weight }) => {
    const of = study.sites[site];
    return of?.handle === -1 ? [{ site, weight, rest: of.rest }] : [];
  });
  const dots = posed(virtual.map(({ rest }) => [rest])).flat();
  const chosen = (site: number | undefined) => (site === falloff?.index ? 'chosen' : '');
  return svg`${ways.map((way) => svg`<path class="way pale" d=${way}/>`)}
    ${ways.map((way, k) => svg`<path class="way ${chosen(shares[k]?.site)}" d=${way}/>`)}
    ${dots.map(([x, y], k) => {
      const { site, weight = 0 } = virtual[k] ?? {};
      const radius = DOT.none + (DOT.all - DOT.none) * Math.sqrt(weight);
      return svg`<circle class="passing ${chosen(site)}" cx=${x.toFixed(1)} cy=${y.toFixed(1)} r=${radius.toFixed(1)}/>`;
    })}`;
}
