/**
 * A notice and its action.
 *
 * Screen readers announce an alert when it appears, but other texts only in a region that exists already.
 */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { NoticeAction } from '../editor/notice';
import type { EditorModel } from '../editor/view_model';
import { icon } from './icons';
import { shortened } from './shortened';

export const notice = (model: EditorModel, dispatch: Dispatch): TemplateResult =>
  html`<div class="notices" role="status">${card(model, dispatch)}</div>`;

function card(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  if (!model.notice) return nothing;
  const { kind, text, action, other } = model.notice;
  // Out of the way of a drag, and of presses that wait for another picture: the notice is about the last one.
  const away = model.pressing || (model.awaiting && kind === 'info');
  const place = `${model.noticeAside ? 'aside' : ''} ${away ? 'away' : ''}`;
  return html`<div class="notice card ${kind} ${place}" part="notice" role=${kind === 'error' ? 'alert' : nothing}
    @pointerenter=${() => dispatch({ type: 'notice-hovered', on: true })}
    @pointerleave=${() => dispatch({ type: 'notice-hovered', on: false })}
    @focusin=${() => dispatch({ type: 'notice-hovered', on: true })}
    @focusout=${() => dispatch({ type: 'notice-hovered', on: false })}
  >
    <p title=${text}>${shortened(text)}</p>
    ${action ? answer(action, false, model, dispatch) : nothing} ${other ? answer(other, true, model, dispatch) : nothing}
    <button type="button" class="button small" aria-label=${model.texts.stage.dismiss} @click=${() => dispatch({ type: 'notice-dismissed' })}>
      ${icon('close')}
    </button>
  </div>`;
}

const answer = (
  { label, readsOnly }: NoticeAction,
  other: boolean,
  { readonly, notice, worded }: EditorModel,
  dispatch: Dispatch,
): TemplateResult =>
  html`<button
    type="button"
    class="link"
    ?disabled=${readonly && notice?.kind === 'info' && !readsOnly}
    @click=${() => dispatch({ type: 'notice-answered', other })}
  >
    ${shortened(worded(label))}
  </button>`;
