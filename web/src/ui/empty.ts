/** What stands on the stage while there is no picture. */
import { html, type TemplateResult } from 'lit';
import type { EditorActions, EditorModel } from './model';

export function emptyStage(model: EditorModel, actions: EditorActions): TemplateResult {
  if (model.progress) return html``;
  if (model.opening)
    return html`<div class="empty opening"><span class="spinner" aria-hidden="true"></span>Opening…</div>`;
  if (model.readonly || model.playing) return html``;
  return html`<div class="empty">
    <p>Drop a picture here, paste one, or</p>
    <button type="button" class="primary" @click=${() => actions.run('open')}>Open a picture</button>
  </div>`;
}
