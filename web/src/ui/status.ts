/** The line at the bottom: what the solver did, that nothing leaves the browser, and how the picture is looked at. */
import { html, nothing, type TemplateResult } from 'lit';
import { commandButton } from './command_button';
import { holdButton } from './hold_button';
import { icon } from './icons';
import type { EditorActions, EditorModel, Progress } from './model';

const counted = (count: number, one: string): string =>
  `${count.toLocaleString('en')} ${one}${count === 1 ? '' : 's'}`;

/** Two digits are enough to see whether something became slower. */
const timed = (ms: number): string =>
  ms >= 1000 ? `${(ms / 1000).toFixed(1)} s` : `${ms >= 10 ? Math.round(ms) : ms.toFixed(1)} ms`;

export function statusLine(model: EditorModel, actions: EditorActions): TemplateResult {
  return html`<div class="status" part="status" role="group" aria-label="Status">
    <span class="solved">
      ${model.progress ? progress(model.progress, model) : model.solved ? solved(model) : nothing}
    </span>
    ${folds(model, actions)}
    <span class="spoken" role="status">${model.folds > 0 ? 'A part of the picture is folded' : ''}</span>
    <span class="private" title="Pictures are opened, warped and saved on this machine only.">
      ${icon('lock')}Nothing leaves your browser
    </span>
    <span class="view" role="group" aria-label="View">
      ${holdButton('preview', model, actions)} ${commandButton('zoom-out', model, actions)}
      <output class="percent" aria-label="Zoom">${Math.round(model.camera.scale * 100)} %</output>
      ${commandButton('zoom-in', model, actions)} ${commandButton('fit', model, actions)}
      ${commandButton('actual', model, actions)}
    </span>
  </div>`;
}

/** A quiet warning of folds, which a press shows or hides; while the guard holds a drag back, it says so. */
function folds(model: EditorModel, actions: EditorActions): TemplateResult | typeof nothing {
  const { folds: count, holding, overlays } = model;
  if (count === 0 && !holding) return nothing;
  const [number, what] = counted(count, 'triangle').split(' ');
  const text = holding ? 'Stopped at a fold' : `${number} ${what} folded`;
  const tip = overlays.folds ? 'Hide the folds' : 'Show the folds';
  return html`<button
    type="button"
    class="button folded ${holding ? 'holding' : ''}"
    part="button"
    data-tip=${tip}
    aria-label="${text}. ${tip}"
    aria-pressed=${String(overlays.folds)}
    @click=${() => actions.overlay('folds', !overlays.folds)}
  >
    ${icon('fold')}<span>${holding ? text : html`${number} <span class="what">${what}</span> folded`}</span>
  </button>`;
}

const progress = ({ label, cancel }: Progress, { readonly }: EditorModel): TemplateResult =>
  html`<span class="spinner" aria-hidden="true"></span>${label}
    ${cancel && !readonly ? html`<button type="button" class="link" @click=${cancel}>Cancel</button>` : nothing}`;

function solved(model: EditorModel): TemplateResult {
  if (!model.solved) return html``;
  const { samples, virtualSites, ms } = model.solved;
  const size = model.picture ? `${model.picture.width} × ${model.picture.height} px` : '';
  return html`<span class="size">${size}</span> <span>${counted(samples, 'sample')}</span>
    <span>${counted(virtualSites, 'virtual handle')}</span> <span>${timed(ms)}</span>`;
}
