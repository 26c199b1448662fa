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

const PAGES: Readonly<Record<StudyPage, Page>> = {
  lens: lensPage,
  cells: cellsPage,
  rounds: roundsPage,
  compare: comparePage,
  settings: settingsPage,
};

function card(model: EditorModel, dispatch: Dispatch, canvases: VariantCanvases): TemplateResult {
  const { page } = model.study;
  const { study: words } = model.texts;
  if (!page) return html``;
  return html`<section class="study card" part="panel" aria-label=${words.title}>
    <header>
      <div class="segments" role="group" aria-label=${words.page}>
        ${STUDY_PAGES.map((name) => tab(name, page, words.pages[name], dispatch))}
      </div>
      <button
        type="button"
        class="button"
        part="button"
        data-tip=${words.close}
        aria-label=${words.close}
        @click=${() => dispatch({ type: 'study-shown', page: null })}
      >
        ${icon('close')}
      </button>
    </header>
    ${
      // A new page begins at its top.
      keyed(
        page,
        html`<div class="page" tabindex="0" role="region" aria-label=${words.pages[page]}>
          ${PAGES[page](model, dispatch, canvases)}
        </div>`,
      )
    }
  </section>`;
}

const tab = (
  name: StudyPage,
  shown: StudyPage,
  word: string,
  dispatch: Dispatch,
): TemplateResult => html`<button
  type="button"
  class="button segment"
  part="button"
  aria-pressed=${String(name === shown)}
  @click=${() => dispatch({ type: 'study-shown', page: name })}
>
  ${word}
</button>`;

const marks = (model: EditorModel): SVGTemplateResult =>
  svg`${lensMarks(model)} ${cellMarks(model)} ${roundMarks(model)}`;

export const studyView: MakeStudyView = (canvases) => ({
  styles: [studyStyle, figureStyle, figuresStyle],
  card: (model, dispatch) => card(model, dispatch, canvases()),
  marks,
  figure,
});
