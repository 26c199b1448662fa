/** The study card: one page at a time, beside the picture. Loaded when it is first shown. */
import { html, type TemplateResult } from 'lit';
import type { Dispatch } from '../../editor/events';
import { STUDY_PAGES, type StudyPage } from '../../editor/study_state';
import type { EditorModel } from '../../editor/view_model';
import { icon } from '../icons';
import type { StudyView } from '../study_view';
import { settingsPage } from './settings_page';
import { studyStyle } from './style';

type Page = (model: EditorModel, dispatch: Dispatch) => TemplateResult;

const PAGES: Readonly<Record<StudyPage, { readonly word: string; readonly page: Page }>> = {
  settings: { word: 'Settings', page: settingsPage },
};

function card(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { page } = model.study;
  if (!page) return html``;
  return html`<section class="study card" part="panel" aria-label="See the paper">
    <header>
      <div class="segments" role="group" aria-label="Page">
        ${STUDY_PAGES.map((name) => tab(name, page, dispatch))}
      </div>
      <button
        type="button"
        class="button"
        part="button"
        data-tip="Close"
        aria-label="Close"
        @click=${() => dispatch({ type: 'study-shown', page: null })}
      >
        ${icon('close')}
      </button>
    </header>
    <div class="page" tabindex="0" role="region" aria-label=${PAGES[page].word}>${PAGES[page].page(model, dispatch)}</div>
  </section>`;
}

const tab = (name: StudyPage, shown: StudyPage, dispatch: Dispatch): TemplateResult => html`<button
  type="button"
  class="button segment"
  part="button"
  aria-pressed=${String(name === shown)}
  @click=${() => dispatch({ type: 'study-shown', page: name })}
>
  ${PAGES[name].word}
</button>`;

export const study: StudyView = { style: studyStyle, card };
