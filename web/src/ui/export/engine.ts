/** The export of a rig for a game engine. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { EngineFormat } from '../../document/engine_rig';
import { BONES, ENGINE_FORMATS, type EngineChoices, INFLUENCES, VERTICES } from '../../editor/engine_choices';
import type { EngineModel } from '../../editor/engine_model';
import { ENGINE_NOTES, engineClipsText, ROUGH_NOTE } from '../../editor/engine_texts';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import { type FieldLook, numberField } from '../number_field';
import { changed, choice, exportRow } from './controls';

const FORMATS = Object.fromEntries(
  Object.entries(ENGINE_FORMATS).map(([format, { name }]) => [format, name]),
) as Readonly<Record<EngineFormat, string>>;

const TARGETS = { zip: 'Zip', folder: 'Folder' } as const;

const COMMON = { unit: '', digits: 0, digitKeys: true, changesNothing: true } as const;
const BONES_LOOK: FieldLook = {
  name: 'bones',
  label: 'Bones',
  tip: 'The most bones besides the root',
  step: 8,
  ...BONES,
  ...COMMON,
};
const VERTICES_LOOK: FieldLook = {
  name: 'vertices',
  label: 'Vertices',
  tip: 'The most vertices of the mesh',
  step: 50,
  ...VERTICES,
  ...COMMON,
};
const influencesLook = (most: number): FieldLook => ({
  name: 'influences',
  label: 'Bones for each vertex',
  step: 1,
  least: INFLUENCES.least,
  most,
  ...COMMON,
});

export function enginePage(engine: EngineModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { choices, influences, loss } = engine;
  const choose = (choice: Partial<EngineChoices>) => dispatch({ type: 'engine-choice-made', choice });
  const field = (look: FieldLook, value: number, set: (value: number) => void) =>
    numberField(look, [value], (change) => set(Math.round(changed(value, change))), model, dispatch);
  return html`<div class="engine-formats">
      ${choice('Format', FORMATS, choices.format, (format) => choose({ format }))}
    </div>
    <p class="faint">${ENGINE_NOTES[choices.format]} ${engineClipsText(engine.clips)}</p>
    <div class="engine-fields">
      ${field(BONES_LOOK, choices.bones, (bones) => choose({ bones }))}
      ${field(VERTICES_LOOK, choices.vertices, (vertices) => choose({ vertices }))}
      ${field(influencesLook(influences.most), influences.now, (influences) => choose({ influences }))}
    </div>
    ${engine.folders ? choice('Files', TARGETS, engine.folder ? 'folder' : 'zip', (into) => choose({ into })) : nothing}
    ${loss ? lossTable(loss) : html`<p class="faint">${ROUGH_NOTE}</p>`}
    ${exportRow(engine.file ?? '', 'rig', false, model, dispatch)}`;
}

const lossTable = ({
  caption,
  rows,
}: NonNullable<EngineModel['loss']>): TemplateResult => html`<table class="engine-loss">
  <caption>
    ${caption}
  </caption>
  <thead>
    <tr>
      <td></td>
      <th scope="col">99 %</th>
      <th scope="col">Largest</th>
    </tr>
  </thead>
  <tbody>
    ${rows.map(
      ({ of, percentile, largest }) => html`<tr>
        <th scope="row">${of}</th>
        <td>${percentile}</td>
        <td>${largest}</td>
      </tr>`,
    )}
  </tbody>
</table>`;
