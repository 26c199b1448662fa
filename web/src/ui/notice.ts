/** A notice: what the editor says, and what can be done about it. */
import { html, nothing, type TemplateResult } from 'lit';
import { icon } from './icons';
import type { EditorActions, EditorModel } from './model';
import { shortened } from './shortened';

export function notice(model: EditorModel, actions: EditorActions): TemplateResult | typeof nothing {
  if (!model.notice) return nothing;
  const { kind, text, action } = model.notice;
  return html`<div class="notice card ${kind}" part="notice" role=${kind === 'error' ? 'alert' : 'status'}>
    <p title=${text}>${shortened(text)}</p>
    ${action ? html`<button type="button" class="link" ?disabled=${model.readonly} @click=${() => action.run()}>${shortened(action.label)}</button>` : nothing}
    <button type="button" class="button small" aria-label="Dismiss" @click=${() => actions.dismiss()}>
      ${icon('close')}
    </button>
  </div>`;
}
