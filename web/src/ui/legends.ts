/** The legend of a heat map, or a hint on how to see it. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { EditorModel } from '../editor/view_model';
import { HEAT_RAMP, MOST_COVERAGE } from '../geometry/heat';
import { draws } from '../tools/machine';

const COLOURS = HEAT_RAMP.map(([red, green, blue, alpha]) => `rgb(${red} ${green} ${blue} / ${alpha})`);
const GRADIENT = `background-image: linear-gradient(to right, ${COLOURS.join(', ')})`;

export function legends(model: EditorModel): TemplateResult | typeof nothing {
  const { overlays, picture, draft, preview, document, tool, brush } = model;
  // The bar of the brush is there.
  if (!picture || draft || preview || brush) return nothing;
  if (overlays.stiffness) return stiffnessLegend;
  if (document.project.handles.length === 0) return nothing;
  if (overlays.coverage) return coverageLegend;
  if (!overlays.reach) return nothing;
  if (document.selection.length > 0) return reachLegend;
  // Drawing tools show their own hint there.
  if (draws(tool)) return nothing;
  return html`<p class="hint" part="hint">Select a handle to see its reach</p>`;
}

const legend = (label: string, least: string, most: string, lines: boolean): TemplateResult =>
  html`<div class="hint legend" part="hint" role="img" aria-label=${label}>
  ${least}<span class="ramp ${lines ? 'lined' : ''}" .style=${GRADIENT}></span>${most}
</div>`;

const reachLegend = legend('Blue follows a little, yellow goes along whole', 'stays', 'goes along', true);
const stiffnessLegend = legend('Blue is a little stiff, yellow keeps its form', 'soft', 'stiff', false);
const coverageLegend = legend(
  'Blue is moved by few handles, yellow by many',
  '1 handle',
  `${MOST_COVERAGE} handles`,
  false,
);
