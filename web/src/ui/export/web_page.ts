/** The export for a web page: a rig, and the code that shows it. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import type { WebPageModel } from '../../editor/web_page_model';
import {
  CODE_NOT_COPIED,
  CODE_NOTE,
  codeCopiedText,
  POSABLE_NOTE,
  WEB_PAGE_NOTE,
  WITHOUT_CLIPS,
} from '../../editor/web_page_texts';
import { exportRow } from './controls';

export function webPage(page: WebPageModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const notes = [WEB_PAGE_NOTE, page.clips > 0 ? '' : WITHOUT_CLIPS, page.posable ? POSABLE_NOTE : ''];
  return html`<p class="faint">${notes.filter(Boolean).join(' ')}</p>
    <label class="code">
      <span>Code</span>
      <textarea
        readonly
        rows="7"
        name="code"
        data-control="code"
        spellcheck="false"
        .value=${page.code}
        @focus=${(event: Event) => (event.target as HTMLTextAreaElement).select()}
      ></textarea>
    </label>
    <p class="faint" role="status">${codeNote(page)}</p>
    ${exportRow(copyButton(dispatch), 'rig', false, model, dispatch)}`;
}

function codeNote({ file, copying }: WebPageModel): string {
  if (copying === null) return CODE_NOTE;
  return copying === 'copied' ? codeCopiedText(file) : CODE_NOT_COPIED;
}

const copyButton = (dispatch: Dispatch): TemplateResult =>
  html`<button type="button" class="link" @click=${() => dispatch({ type: 'code-asked' })}>
    Copy code
  </button>`;
