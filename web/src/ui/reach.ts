/** The legend of the reach's heat map, or a hint on how to see it. */
import { html, nothing, type TemplateResult } from 'lit';
import { REACH_RAMP } from '../geometry/reach';
import { draws } from '../tools/machine';
import type { EditorModel } from './model';

const COLOURS = REACH_RAMP.map(([red, green, blue, alpha]) => `rgb(${red} ${green} ${blue} / ${alpha})`);

export function reachHint(model: EditorModel): TemplateResult | typeof nothing {
  const { overlays, picture, draft, bare, document, tool } = model;
  if (!overlays.reach || !picture || draft || bare || document.project.handles.length === 0) return nothing;
  if (document.selection.length > 0) return legend;
  // Such tools have their own hint there, and draw something before anything is selected.
  if (draws(tool)) return nothing;
  return html`<p class="hint" part="hint">Select a handle to see its reach</p>`;
}

const legend = html`<div class="hint legend" part="hint" role="img" aria-label="Blue follows a little, yellow goes along whole">
  stays<span class="ramp" .style=${`background-image: linear-gradient(to right, ${COLOURS.join(', ')})`}></span>goes along
</div>`;
