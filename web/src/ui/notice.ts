/**
 * A notice and its action.
 *
 * Screen readers announce an alert when it appears, but other texts only in a region that exists already.
 */
import { html, nothing, type TemplateResult } from 'lit';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { icon } from './icons';
import { shortened } from './shortened';

export const notice = (model: EditorModel, dispatch: Dispatch): TemplateResult =>
  html`<div class="notices" role="status">${card(model, dispatch)}</div>`;

function card(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  if (!model.notice) return nothing;
  const { kind, text, action } = model.notice;
  return html`<div class="notice card ${kind}" part="notice" role=${kind === 'error' ? 'alert' : nothing}
    @pointerenter=${() => dispatch({ type: 'notice-hovered', on: true })}
    @pointerleave=${() => dispatch({ type: 'notice-hovered', on: false })}
    @focusin=${() => dispatch({ type: 'notice-hovered', on: true })}
    @focusout=${() => dispatch({ type: 'notice-hovered', on: false })}
  >
    <p title=${text}>${shortened(text)}</p>
    ${action ? html`<button type="button" class="link" ?disabled=${model.readonly && kind === 'info' && !action.readsOnly} @click=${() => dispatch({ type: 'notice-answered' })}>${shortened(action.label)}</button>` : nothing}
    <button type="button" class="button small" aria-label="Dismiss" @click=${() => dispatch({ type: 'notice-dismissed' })}>
      ${icon('close')}
    </button>
  </div>`;
}
