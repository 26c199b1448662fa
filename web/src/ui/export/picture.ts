/** The export of a picture: format, quality, area and size. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import { EXPORT_FORMATS, type ExportChoices, type ExportFormat } from '../../editor/export_choices';
import type { EditorModel } from '../../editor/view_model';
import type { Area } from '../../geometry/area';
import { numberField } from '../number_field';
import { changed, choice, colourOption, exportRow, qualityOption, sizeLook, sizeText } from './controls';

const PIXEL_FORMATS = { png: 'PNG', jpeg: 'JPEG', webp: 'WebP' } as const;
const FORMATS: Readonly<Record<ExportFormat, string>> = { ...PIXEL_FORMATS, svg: 'SVG' };

export function picturePage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { choices, isOfDrawing, size } = model.exporting;
  const { format, quality, percent, area, background } = choices;
  const { texts } = model;
  const { exporting: words } = texts;
  const areas: Readonly<Record<Area, string>> = {
    picture: words.original,
    grown: words.allOfIt,
    covered: words.covered,
  };
  const choose = (choice: Partial<ExportChoices>) => dispatch({ type: 'export-choice-made', choice });
  const resize = numberField(
    sizeLook(texts),
    [percent],
    (change) => choose({ percent: changed(percent, change) }),
    model,
    dispatch,
  );
  return html`${choice<ExportFormat>(words.format, isOfDrawing ? FORMATS : PIXEL_FORMATS, format, (format) => choose({ format }))}
    <p class="faint">${words.formatNotes[format]}</p>
    ${format === 'png' || format === 'svg' ? nothing : qualityOption(quality, texts, (quality) => choose({ quality }))}
    ${format === 'jpeg' ? colourOption(words.background, 'background', background, (background) => choose({ background })) : nothing}
    ${choice(words.area, areas, area, (area) => choose({ area }), format === 'svg' ? ['covered'] : [])}
    <p class="faint">${words.areaNotes[area]}</p>
    ${format === 'svg' ? nothing : resize}
    ${exportRow(format === 'svg' ? '' : sizeText(size, area !== 'picture', texts), words.export(EXPORT_FORMATS[format].name), false, model, dispatch)}`;
}
