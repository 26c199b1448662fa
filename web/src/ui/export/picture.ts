/** The export of a picture: format, quality, area and size. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import { EXPORT_FORMATS, type ExportChoices, type ExportFormat } from '../../editor/export_choices';
import type { EditorModel } from '../../editor/view_model';
import type { Area } from '../../geometry/area';
import { numberField } from '../number_field';
import { changed, choice, colourOption, exportRow, qualityOption, SIZE, sizeText } from './controls';

const PIXEL_FORMATS = { png: 'PNG', jpeg: 'JPEG', webp: 'WebP' } as const;
const FORMATS: Readonly<Record<ExportFormat, string>> = { ...PIXEL_FORMATS, svg: 'SVG' };

const FORMAT_NOTES: Readonly<Record<ExportFormat, string>> = {
  png: 'Every pixel as it is, with transparency.',
  jpeg: 'Small files of photographs, without transparency.',
  webp: 'Small files, with transparency.',
  svg: 'The drawing with bent paths, which stay sharp at any size.',
};

const AREAS: Readonly<Record<Area, string>> = {
  picture: 'Original',
  grown: 'All of it',
  covered: 'Covered',
};

const AREA_NOTES: Readonly<Record<Area, string>> = {
  picture: 'The rectangle of the original.',
  grown: 'Grown to hold the parts that are bent beyond the original.',
  covered: 'Only the covered part, without an empty border.',
};

export function picturePage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { choices, isOfDrawing, size } = model.exporting;
  const { format, quality, percent, area, background } = choices;
  const choose = (choice: Partial<ExportChoices>) => dispatch({ type: 'export-choice-made', choice });
  const resize = numberField(
    SIZE,
    [percent],
    (change) => choose({ percent: changed(percent, change) }),
    model,
    dispatch,
  );
  return html`${choice<ExportFormat>('Format', isOfDrawing ? FORMATS : PIXEL_FORMATS, format, (format) => choose({ format }))}
    <p class="faint">${FORMAT_NOTES[format]}</p>
    ${format === 'png' || format === 'svg' ? nothing : qualityOption(quality, (quality) => choose({ quality }))}
    ${format === 'jpeg' ? colourOption('Background', 'background', background, (background) => choose({ background })) : nothing}
    ${choice('Area', AREAS, area, (area) => choose({ area }), format === 'svg' ? ['covered'] : [])}
    <p class="faint">${AREA_NOTES[area]}</p>
    ${format === 'svg' ? nothing : resize}
    ${exportRow(format === 'svg' ? '' : sizeText(size, area !== 'picture'), EXPORT_FORMATS[format].name, false, model, dispatch)}`;
}
