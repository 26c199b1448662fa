/** The legend of a heat map, or a hint on how to see it. */

import { html, nothing, type TemplateResult } from 'lit-html';
import type { EditorModel } from '../editor/view_model';
import { HEAT_RAMP, MOST_COVERAGE } from '../geometry/heat';
import type { Texts } from '../texts/texts';
import { draws } from '../tools/machine';

const COLOURS = HEAT_RAMP.map(([red, green, blue, alpha]) => `rgb(${red} ${green} ${blue} / ${alpha})`);
const GRADIENT = `background-image: linear-gradient(to right, ${COLOURS.join(', ')})`;

export function legends(model: EditorModel): TemplateResult | typeof nothing {
  const { overlays, picture, draft, preview, document, tool, brush, texts } = model;
  // The bar of the brush is shown.
  if (!picture || draft || preview || brush) return nothing;
  if (overlays.stiffness) return stiffnessLegend(texts);
  if (document.project.handles.length === 0) return nothing;
  if (overlays.coverage) return coverageLegend(texts);
  if (!overlays.reach) return nothing;
  if (document.selection.length > 0) return reachLegend(texts);
  // Drawing tools show their own hint there.
  if (draws(tool)) return nothing;
  return html`<p class="hint" part="hint">${texts.overlays.selectForReach}</p>`;
}

const legend = (label: string, least: string, most: string, lines: boolean): TemplateResult =>
  html`<div class="hint legend" part="hint" role="img" aria-label=${label}>
  ${least}<span class="ramp ${lines ? 'lined' : ''}" .style=${GRADIENT}></span>${most}
</div>`;

const reachLegend = ({ overlays }: Texts) =>
  legend(overlays.reachLegend, overlays.stays, overlays.goesAlong, true);
const stiffnessLegend = ({ overlays }: Texts) =>
  legend(overlays.stiffnessLegend, overlays.soft, overlays.stiff, false);
const coverageLegend = ({ overlays }: Texts) =>
  legend(overlays.coverageLegend, overlays.coverage(1), overlays.coverage(MOST_COVERAGE), false);
