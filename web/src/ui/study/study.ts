/** The study card: one page at a time, beside the picture. Loaded when it is first shown. */
import { html, type SVGTemplateResult, svg, type TemplateResult } from 'lit-html';
import { keyed } from 'lit-html/directives/keyed.js';
import type { Dispatch } from '../../editor/events';
import { STUDY_PAGES, type StudyPage } from '../../editor/study_state';
import type { EditorModel } from '../../editor/view_model';
import { icon } from '../icons';
import type { MakeStudyView, VariantCanvases } from '../study_view';
import { cellMarks } from './cell_marks';
import { cellsPage } from './cells_page';
import { comparePage } from './compare_page';
import { figureStyle } from './figure_style';
import { figure } from './figures';
import { figuresStyle } from './figures_style';
import { lensMarks } from './lens_marks';
import { lensPage } from './lens_page';
import { roundMarks } from './round_marks';
import { roundsPage } from './rounds_page';
import { settingsPage } from './settings_page';
import { studyStyle } from './style';

type Page = (model: EditorModel, dispatch: Dispatch, canvases: VariantCanvases) => TemplateResult;

const PAGES: Readonly<Record<StudyPage, { readonly word: string; readonly page: Page }>> = {
  lens: { word: 'Lens', page: lensPage },
  cells: { word: 'Cells', page: cellsPage },
  rounds: { word: 'Rounds', page: roundsPage },
  compare: { word: 'Compare', page: comparePage },
  settings: { word: 'Settings', page: settingsPage },
};

function card(model: EditorModel, dispatch: Dispatch, canvases: VariantCanvases): TemplateResult {
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
    ${
      // A new page begins at its top.
      keyed(
        page,
        html`<div class="page" tabindex="0" role="region" aria-label=${PAGES[page].word}>
          ${PAGES[page].page(model, dispatch, canvases)}
        </div>`,
      )
    }
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

const marks = (model: EditorModel): SVGTemplateResult =>
  svg`${lensMarks(model)} ${cellMarks(model)} ${roundMarks(model)}`;

export const studyView: MakeStudyView = (canvases) => ({
  styles: [studyStyle, figureStyle, figuresStyle],
  card: (model, dispatch) => card(model, dispatch, canvases()),
  marks,
  figure,
});
