/** Figures for saving, each a self-contained SVG. */
import { html, svg, type TemplateResult } from 'lit-html';
import { lensModel } from '../../editor/lens_model';
import { roundModel } from '../../editor/rounds_model';
import type { FigureName } from '../../editor/study_state';
import type { EditorModel } from '../../editor/view_model';
import type { VariantPictures } from '../study_view';
import { cellsMap } from './cells_page';
import { compareFigure } from './compare_figure';
import { type Drawn, linesOf } from './figure';
import { figureKey } from './figure_key';
import { lensFigure } from './lens_figure';
import { CURVE_HEIGHT, roundMap, scoreCurve } from './rounds_page';

const MAP = { width: 460, height: 560 } as const;
const LINE = 17;
/** Characters that fit below a map. */
const LINE_LENGTH = 68;

/** The SVG of a figure; null while it is not known. */
export function figure(
  name: FigureName,
  model: EditorModel,
  pictures: VariantPictures | null,
): TemplateResult | null {
  const { texts } = model;
  switch (name) {
    case 'lens': {
      const shown = lensModel(model.study);
      return shown && whole(texts.lens.title, lensFigure(shown, texts));
    }
    case 'cells':
      return cellsFigure(model);
    case 'rounds':
      return roundsFigure(model);
    case 'compare':
      return pictures && whole(texts.compare.title, compareFigure(pictures, texts));
  }
}

const whole = (
  title: string,
  { width, height, content }: Drawn,
): TemplateResult => html`<svg xmlns="http://www.w3.org/2000/svg" class="figure" width=${width} height=${height} viewBox="0 0 ${width} ${height}">
    <title>${title}</title>
    <rect class="paper" width=${width} height=${height}/>
    ${content}
  </svg>`;

function cellsFigure(model: EditorModel): TemplateResult | null {
  const study = model.study.explained?.study;
  if (!study) return null;
  const map = cellsMap(study, model, MAP.width, MAP.height);
  const content = svg`${map.content}
    <g transform="translate(16 ${map.height + LINE})">
      ${figureKey([
        ['farthest', model.texts.cells.toFarthest],
        ['nearest', model.texts.cells.toNearest],
      ])}
    </g>`;
  return whole(model.texts.cells.title, { content, width: map.width, height: map.height + 2 * LINE });
}

function roundsFigure(model: EditorModel): TemplateResult | null {
  const shown = roundModel(model.study);
  if (!shown) return null;
  const map = roundMap(shown, MAP.width, MAP.height);
  const words = linesOf(model.worded(shown.words), LINE_LENGTH);
  const below = map.height + (words.length + 2) * LINE;
  const content = svg`${map.content}
    ${words.map((line, at) => svg`<text x="16" y=${map.height + (at + 1) * LINE}>${line}</text>`)}
    <g transform="translate(0 ${below})">${scoreCurve(shown, MAP.width, model.texts.rounds)}</g>`;
  return whole(model.texts.rounds.figure(shown.index + 1), {
    content,
    width: MAP.width,
    height: below + CURVE_HEIGHT + 8,
  });
}
