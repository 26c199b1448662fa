/** The export of maps and weights. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import { EVERY, type MapChoices } from '../../editor/map_choices';
import type { MapModel } from '../../editor/map_model';
import {
  heatText,
  MAP_FORMAT_NOTES,
  MAP_NAMES,
  MAP_NOTES,
  pointsText,
  tableNote,
} from '../../editor/map_texts';
import type { EditorModel } from '../../editor/view_model';
import { type FieldLook, numberField } from '../number_field';
import { changed, choice, exportRow, sizeText } from './controls';

const FORMATS = { exr: 'EXR', png: 'PNG' } as const;
const AREAS = { picture: 'Original', grown: 'All of it' } as const;
const TABLES = { npy: 'NPY', csv: 'CSV' } as const;
const OWNERS = { sites: 'All sites', handle: 'Selected handle' } as const;

const EVERY_LOOK: FieldLook = {
  name: 'every',
  label: 'Pixels from point to point',
  unit: '',
  step: 1,
  digits: 0,
  digitKeys: true,
  changesNothing: true,
  ...EVERY,
};

type Choose = (choice: Partial<MapChoices>) => void;

export function mapPage(maps: MapModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const choose: Choose = (choice) => dispatch({ type: 'map-choice-made', choice });
  const { map } = maps.choices;
  return html`<div class="map-kinds">${choice('Map', MAP_NAMES, map, (map) => choose({ map }))}</div>
    <p class="faint">${MAP_NOTES[map]}</p>
    ${map === 'heat' ? heat(maps) : map === 'weights' ? weights(maps, choose, model, dispatch) : warpMap(maps, choose)}
    ${exportRow(told(maps), map === 'weights' ? map : 'map', maps.file === null, model, dispatch)}`;
}

const warpMap = (
  { choices: { format, area } }: MapModel,
  choose: Choose,
): TemplateResult => html`${choice('Format', FORMATS, format, (format) => choose({ format }))}
  <p class="faint">${MAP_FORMAT_NOTES[format]}</p>
  ${choice('Area', AREAS, area, (area) => choose({ area }))}`;

const heat = ({ handle }: MapModel): TemplateResult => html`<p class="faint">${heatText(handle)}</p>`;

function weights(maps: MapModel, choose: Choose, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { choices } = maps;
  const { table, of, every } = choices;
  const field = numberField(
    EVERY_LOOK,
    [every],
    (change) => choose({ every: Math.round(changed(every, change)) }),
    model,
    dispatch,
  );
  return html`${choice('Of', OWNERS, of, (of) => choose({ of }))}
    ${of === 'handle' ? heat(maps) : nothing}
    ${choice('Format', TABLES, table, (table) => choose({ table }))}
    <p class="faint">${tableNote(choices, of === 'sites')}</p>
    ${field}`;
}

function told({ choices: { map, area }, file, size }: MapModel): TemplateResult {
  const sides = map === 'weights' ? pointsText(size) : sizeText(size, area === 'grown');
  return html`${file === null ? nothing : html`<span class="map-file">${file}</span>`}${sides}`;
}
