/** The line at the bottom: figures of the solution, the promise of privacy, and the controls of the view. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import { foldsText, WITHOUT_FOLDS } from '../editor/fold_texts';
import type { Task } from '../editor/task';
import type { EditorModel } from '../editor/view_model';
import { commandButton } from './command_button';
import { holdButton } from './hold_button';
import { icon } from './icons';

const GROUPED = new Intl.NumberFormat('en');

const counted = (count: number, one: string): string =>
  `${GROUPED.format(count)} ${one}${count === 1 ? '' : 's'}`;

/** A duration with two digits, enough to see whether something became slower. */
const timed = (ms: number): string =>
  ms >= 1000 ? `${(ms / 1000).toFixed(1)} s` : `${ms >= 10 ? Math.round(ms) : ms.toFixed(1)} ms`;

export function statusLine(model: EditorModel, dispatch: Dispatch): TemplateResult {
  return html`<div class="status" part="status" role="group" aria-label="Status">
    <span class="solved">
      ${model.task ? progress(model.task, model, dispatch) : model.awaiting && model.picture ? OPENING : solved(model)}
    </span>
    ${creases(model, dispatch)}
    <span class="spoken" role="status">${model.creases.length > 0 ? 'The picture has creases' : ''}</span>
    <span class="private" title="Pictures are opened, warped and saved on this machine only.">
      ${icon('lock')}Nothing leaves your browser
    </span>
    <span class="view" role="group" aria-label="View">
      ${holdButton('preview', 'See it', model, dispatch)}
      ${commandButton('zoom-out', model, dispatch, { caption: 'Out' })}
      <output class="percent" aria-label="Zoom">${Math.round(model.camera.scale * 100)} %</output>
      ${commandButton('zoom-in', model, dispatch, { caption: 'In' })}
      ${commandButton('fit', model, dispatch, { caption: 'Fit' })}
      ${commandButton('actual', model, dispatch, { caption: 'Actual' })}
    </span>
  </div>`;
}

/** A quiet warning of creases. One press shows or hides them, another zooms to the next one. */
function creases(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { creases: places, holding, overlays } = model;
  if (places.length === 0 && !holding) return nothing;
  const text = holding ? 'Stopped at a fold' : counted(places.length, 'crease');
  const tip = overlays.creases ? 'Hide the creases' : 'Show the creases';
  return html`<span class="creased">
    <button
      type="button"
      class="button shown ${holding ? 'holding' : ''}"
      part="button"
      data-tip=${tip}
      aria-label="${text}. ${tip}"
      aria-pressed=${String(overlays.creases)}
      @click=${() => dispatch({ type: 'overlay-switched', overlay: 'creases', on: !overlays.creases })}
    >
      ${icon('fold')}<span>${text}</span>
    </button>
    ${places.length > 0 && !holding ? html`${zoomButton(places.length, dispatch)} ${commandButton('without-folds', model, dispatch, { label: outOfFolds(model) })}` : nothing}
  </span>`;
}

/** The way out of the folds, with the handles that force them. */
const outOfFolds = ({ forcing }: EditorModel): string =>
  forcing.length === 0 ? WITHOUT_FOLDS : `${foldsText(forcing)} ${WITHOUT_FOLDS}`;

function zoomButton(count: number, dispatch: Dispatch): TemplateResult {
  const label = count > 1 ? 'Zoom to the next crease' : 'Zoom to the crease';
  return html`<button
    type="button"
    class="button"
    part="button"
    data-tip=${label}
    aria-label=${label}
    @click=${() => dispatch({ type: 'crease-zoomed' })}
  >
    ${icon('magnifier')}
  </button>`;
}

const OPENING = html`<span class="spinner" aria-hidden="true"></span>Opening…`;

export const percentOf = ({ fraction = 0 }: Task): number => Math.round(fraction * 100);

/** A task with its progress, and the button that cancels it. Anybody may cancel an export, which changes nothing. */
export const progress = (task: Task, { readonly }: EditorModel, dispatch: Dispatch): TemplateResult => {
  const { name, label, cancellable, fraction, left } = task;
  const mayCancel = cancellable && (!readonly || name === 'export');
  return html`<span class="spinner" aria-hidden="true"></span>
    <span class="task">${label}${fraction === undefined ? '' : ` ${percentOf(task)} %`}${left ? `, ${left}` : ''}</span>
    ${mayCancel ? html`<button type="button" class="link" @click=${() => dispatch({ type: 'task-cancelled', task: name })}>Cancel</button>` : nothing}`;
};

function solved(model: EditorModel): TemplateResult | typeof nothing {
  if (!model.solved) return nothing;
  const { samples, virtualSites, ms } = model.solved;
  const size = model.picture ? `${model.picture.width} × ${model.picture.height} px` : '';
  return html`<span class="size">${size}</span> <span>${counted(samples, 'sample')}</span>
    <span>${counted(virtualSites, 'virtual handle')}</span> <span>${timed(ms)}</span>`;
}
