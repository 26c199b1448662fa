/** The export of maps and weights. */

import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import { EVERY, type MapChoices } from '../../editor/map_choices';
import type { MapModel } from '../../editor/map_model';
import type { EditorModel } from '../../editor/view_model';
import type { Texts } from '../../texts/texts';
import { type FieldLook, numberField } from '../number_field';
import { changed, choice, exportRow, sizeText } from './controls';

const FORMATS = { exr: 'EXR', png: 'PNG' } as const;
const TABLES = { npy: 'NPY', csv: 'CSV' } as const;

const everyLook = ({ maps }: Texts): FieldLook => ({
  name: 'every',
  label: maps.every,
  unit: '',
  step: 1,
  digits: 0,
  digitKeys: true,
  changesNothing: true,
  ...EVERY,
});

type Choose = (choice: Partial<MapChoices>) => void;

export function mapPage(maps: MapModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const choose: Choose = (choice) => dispatch({ type: 'map-choice-made', choice });
  const { map } = maps.choices;
  const { exporting, maps: words } = model.texts;
  const label = map === 'weights' ? exporting.exportWeights : exporting.exportMap;
  return html`<div class="map-kinds">${choice(words.map, words.names, map, (map) => choose({ map }))}</div>
    <p class="faint">${words.notes[map]}</p>
    ${map === 'heat' ? heat(maps, model) : map === 'weights' ? weights(maps, choose, model, dispatch) : warpMap(maps, model.texts, choose)}
    ${exportRow(summary(maps, model.texts), label, maps.file === null, model, dispatch)}`;
}

const warpMap = (
  { choices: { format, area } }: MapModel,
  { exporting, maps }: Texts,
  choose: Choose,
): TemplateResult => html`${choice(exporting.format, FORMATS, format, (format) => choose({ format }))}
  <p class="faint">${maps.formatNotes[format]}</p>
  ${choice(exporting.area, { picture: exporting.original, grown: exporting.allOfIt }, area, (area) => choose({ area }))}`;

const heat = ({ handle }: MapModel, { texts, worded }: EditorModel): TemplateResult =>
  html`<p class="faint">${handle === null ? texts.notices.selectOne : texts.maps.selected(worded(handle))}</p>`;

function weights(maps: MapModel, choose: Choose, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { choices } = maps;
  const { table, of, every } = choices;
  const field = numberField(
    everyLook(model.texts),
    [every],
    (change) => choose({ every: Math.round(changed(every, change)) }),
    model,
    dispatch,
  );
  const { exporting, maps: words } = model.texts;
  const owners = { sites: words.allSites, handle: words.selectedHandle };
  return html`${choice(words.of, owners, of, (of) => choose({ of }))}
    ${of === 'handle' ? heat(maps, model) : nothing}
    ${choice(exporting.format, TABLES, table, (table) => choose({ table }))}
    <p class="faint">${tableNote(choices, words)}</p>
    ${field}`;
}

/** The array of all sites comes with their list. */
function tableNote({ table, of }: MapChoices, { csvNote, npyNote, npyZipNote }: Texts['maps']): string {
  if (table === 'csv') return csvNote;
  return of === 'sites' ? npyZipNote : npyNote;
}

function summary({ choices: { map, area }, file, size }: MapModel, texts: Texts): TemplateResult {
  const points = size ? texts.maps.points(size.width, size.height) : '';
  const sides = map === 'weights' ? points : sizeText(size, area === 'grown', texts);
  return html`${file === null ? nothing : html`<span class="map-file">${file}</span>`}${sides}`;
}
