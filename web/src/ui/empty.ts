/** The stage without a picture. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';

export function emptyStage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  if (model.task) return html``;
  if (model.opening)
    return html`<div class="empty opening"><span class="spinner" aria-hidden="true"></span>${model.texts.stage.opening}</div>`;
  if (model.readonly || model.posable || !model.offers('open')) return html``;
  return html`<div class="empty">
    <p>${model.texts.stage.drop}</p>
    <button type="button" class="primary" @click=${() => dispatch({ type: 'command-run', command: 'open' })}>${model.texts.stage.openPicture}</button>
  </div>`;
}
