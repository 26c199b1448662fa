/** The line at the bottom: figures of the solution, the promise of privacy, and the controls of the view. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import { foldsWords } from '../editor/notice_words';
import type { EditorModel, ShownTask } from '../editor/view_model';
import type { Texts } from '../texts/texts';
import { commandButton } from './command_button';
import { holdButton } from './hold_button';
import { icon } from './icons';

/** A duration with two digits, enough to see whether something became slower. */
const timed = (ms: number): string =>
  ms >= 1000 ? `${(ms / 1000).toFixed(1)} s` : `${ms >= 10 ? Math.round(ms) : ms.toFixed(1)} ms`;

export function statusLine(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { status: words } = model.texts;
  return html`<div class="status" part="status" role="group" aria-label=${words.label}>
    <span class="solved">
      ${model.task ? progress(model.task, model, dispatch) : model.awaiting && model.picture ? opening(model) : solved(model)}
    </span>
    ${creases(model, dispatch)}
    <span class="spoken" role="status">${model.creases.length > 0 ? words.hasCreases : ''}</span>
    <span class="private" title=${words.privacyTip}>
      ${icon('lock')}${words.privacy}
    </span>
    <span class="view" role="group" aria-label=${words.view}>
      ${holdButton('preview', words.seeIt, model, dispatch)}
      ${commandButton('zoom-out', model, dispatch, { caption: words.out })}
      <output class="percent" aria-label=${words.zoom}>${Math.round(model.camera.scale * 100)} %</output>
      ${commandButton('zoom-in', model, dispatch, { caption: words.in })}
      ${commandButton('fit', model, dispatch, { caption: words.fit })}
      ${commandButton('actual', model, dispatch, { caption: words.actual })}
    </span>
  </div>`;
}

/** A quiet warning of creases. One press shows or hides them, another zooms to the next one. */
function creases(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { creases: places, holding, overlays } = model;
  if (places.length === 0 && !holding) return nothing;
  const { status: words } = model.texts;
  const text = holding ? words.stoppedAtFold : words.creases(places.length);
  const tip = overlays.creases ? words.hideCreases : words.showCreases;
  return html`<span class="creased">
    <button
      type="button"
      class="button shown ${holding ? 'holding' : ''}"
      part="button"
      data-tip=${tip}
      aria-label=${words.creasesAnd(text, tip)}
      aria-pressed=${String(overlays.creases)}
      @click=${() => dispatch({ type: 'overlay-switched', overlay: 'creases', on: !overlays.creases })}
    >
      ${icon('fold')}<span>${text}</span>
    </button>
    ${places.length > 0 && !holding ? html`${zoomButton(places.length, words, dispatch)} ${commandButton('without-folds', model, dispatch, { label: outOfFolds(model) })}` : nothing}
  </span>`;
}

/** The way out of the folds, with the handles that force them. */
const outOfFolds = ({ forcing, texts, worded }: EditorModel): string => {
  const way = texts.commands['without-folds'];
  return forcing.length === 0 ? way : texts.names.sentences([worded(foldsWords(forcing)), way]);
};

function zoomButton(count: number, words: Texts['status'], dispatch: Dispatch): TemplateResult {
  const label = count > 1 ? words.zoomToNextCrease : words.zoomToCrease;
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

const opening = ({ texts }: EditorModel): TemplateResult =>
  html`<span class="spinner" aria-hidden="true"></span>${texts.stage.opening}`;

export const percentOf = ({ fraction = 0 }: ShownTask): number => Math.round(fraction * 100);

/** A task with its progress, and the button that cancels it. Anybody may cancel an export, which changes nothing. */
export const progress = (
  task: ShownTask,
  { readonly, texts }: EditorModel,
  dispatch: Dispatch,
): TemplateResult => {
  const { name, label, cancellable, fraction, left } = task;
  const mayCancel = cancellable && (!readonly || name === 'export');
  return html`<span class="spinner" aria-hidden="true"></span>
    <span class="task">${label}${fraction === undefined ? '' : ` ${percentOf(task)} %`}${left ? `, ${left}` : ''}</span>
    ${mayCancel ? html`<button type="button" class="link" @click=${() => dispatch({ type: 'task-cancelled', task: name })}>${texts.status.cancel}</button>` : nothing}`;
};

function solved(model: EditorModel): TemplateResult | typeof nothing {
  if (!model.solved) return nothing;
  const { samples, virtualSites, ms } = model.solved;
  const size = model.picture ? `${model.picture.width} × ${model.picture.height} px` : '';
  return html`<span class="size">${size}</span> <span>${model.texts.status.samples(samples)}</span>
    <span>${model.texts.status.virtualHandles(virtualSites)}</span> <span>${timed(ms)}</span>`;
}
