/**
 * A notice: what the editor says, and what can be done about it.
 *
 * Screen readers announce an alert that appears, but other words only in a region that has been there before.
 */
import { html, nothing, type TemplateResult } from 'lit';
import { icon } from './icons';
import type { EditorActions, EditorModel } from './model';
import { shortened } from './shortened';

export const notice = (model: EditorModel, actions: EditorActions): TemplateResult =>
  html`<div class="notices" role="status">${card(model, actions)}</div>`;

function card(model: EditorModel, actions: EditorActions): TemplateResult | typeof nothing {
  if (!model.notice) return nothing;
  const { kind, text, action } = model.notice;
  return html`<div class="notice card ${kind}" part="notice" role=${kind === 'error' ? 'alert' : nothing}
    @pointerenter=${() => actions.linger(true)}
    @pointerleave=${() => actions.linger(false)}
    @focusin=${() => actions.linger(true)}
    @focusout=${() => actions.linger(false)}
  >
    <p title=${text}>${shortened(text)}</p>
    ${action ? html`<button type="button" class="link" ?disabled=${model.readonly && kind === 'info' && !action.reads} @click=${() => action.run()}>${shortened(action.label)}</button>` : nothing}
    <button type="button" class="button small" aria-label="Dismiss" @click=${() => actions.dismiss()}>
      ${icon('close')}
    </button>
  </div>`;
}
