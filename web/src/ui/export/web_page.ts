/** The export for a web page: a rig, and the code that shows it. */

import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import type { WebPageModel } from '../../editor/web_page_model';
import type { Texts } from '../../texts/texts';
import { choice, exportRow } from './controls';

export function webPage(page: WebPageModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { webPage: words, names, exporting } = model.texts;
  const notes = [
    words.note,
    ...(page.clips > 0 ? [] : [words.withoutClips]),
    ...(page.posable && page.solver ? [words.solver] : []),
  ];
  return html`${page.posable === null ? nothing : readers(page.posable, words, dispatch)}
    <p class="faint">${names.sentences(notes)}</p>
    <label class="code">
      <span>${words.code}</span>
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
    <p class="faint" role="status">${codeNote(page, words)}</p>
    ${exportRow(copyButton(words, dispatch), exporting.exportRig, false, model, dispatch)}`;
}

const readers = (posable: boolean, words: Texts['webPage'], dispatch: Dispatch): TemplateResult =>
  choice(words.readers, { watch: words.watch, pose: words.pose }, posable ? 'pose' : 'watch', (chosen) =>
    dispatch({ type: 'posable-chosen', posable: chosen === 'pose' }),
  );

function codeNote({ file, copying }: WebPageModel, words: Texts['webPage']): string {
  if (copying === null) return words.codeNote;
  return copying === 'copied' ? words.codeCopied(file) : words.codeNotCopied;
}

const copyButton = (words: Texts['webPage'], dispatch: Dispatch): TemplateResult =>
  html`<button type="button" class="link" @click=${() => dispatch({ type: 'code-asked' })}>
    ${words.copyCode}
  </button>`;
