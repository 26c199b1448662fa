/** The export of a rig for a game engine. */

import { html, nothing, type TemplateResult } from 'lit-html';
import type { EngineFormat } from '../../document/engine_rig';
import { BONES, ENGINE_FORMATS, type EngineChoices, INFLUENCES, VERTICES } from '../../editor/engine_choices';
import type { EngineModel } from '../../editor/engine_model';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import type { Texts } from '../../texts/texts';
import { type FieldLook, numberField } from '../number_field';
import { changed, choice, exportRow } from './controls';

const FORMATS = Object.fromEntries(
  Object.entries(ENGINE_FORMATS).map(([format, { name }]) => [format, name]),
) as Readonly<Record<EngineFormat, string>>;

const COMMON = { unit: '', digits: 0, digitKeys: true, changesNothing: true } as const;

const bonesLook = ({ engine }: Texts, least: number): FieldLook => ({
  name: 'bones',
  label: engine.bones,
  tip: engine.bonesTip,
  step: 8,
  least,
  most: BONES.most,
  ...COMMON,
});
const verticesLook = ({ engine }: Texts): FieldLook => ({
  name: 'vertices',
  label: engine.vertices,
  tip: engine.verticesTip,
  step: 50,
  ...VERTICES,
  ...COMMON,
});
const influencesLook = ({ engine }: Texts, most: number): FieldLook => ({
  name: 'influences',
  label: engine.influences,
  step: 1,
  least: INFLUENCES.least,
  most,
  ...COMMON,
});

export function enginePage(engine: EngineModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { choices, bones, influences, loss } = engine;
  const { texts } = model;
  const { engine: words } = texts;
  const targets = { zip: words.zip, folder: words.folder };
  const choose = (choice: Partial<EngineChoices>) => dispatch({ type: 'engine-choice-made', choice });
  const field = (look: FieldLook, value: number, set: (value: number) => void) =>
    numberField(look, [value], (change) => set(Math.round(changed(value, change))), model, dispatch);
  return html`<div class="engine-formats">
      ${choice(texts.exporting.format, FORMATS, choices.format, (format) => choose({ format }))}
    </div>
    <p class="faint">${texts.names.sentences([words.notes[choices.format], words.clips(engine.clips)])}</p>
    <div class="engine-fields">
      ${field(bonesLook(texts, bones.least), bones.now, (bones) => choose({ bones }))}
      ${field(verticesLook(texts), choices.vertices, (vertices) => choose({ vertices }))}
      ${field(influencesLook(texts, influences.most), influences.now, (influences) => choose({ influences }))}
    </div>
    ${engine.folders ? choice(words.files, targets, engine.folder ? 'folder' : 'zip', (into) => choose({ into })) : nothing}
    ${loss ? lossTable(loss, model) : html`<p class="faint">${words.rough}</p>`}
    ${exportRow(engine.file ?? '', texts.exporting.exportRig, false, model, dispatch)}`;
}

const lossTable = (
  { caption, rows }: NonNullable<EngineModel['loss']>,
  { texts, worded }: EditorModel,
): TemplateResult => html`<table class="engine-loss">
  <caption>
    ${worded(caption)}
  </caption>
  <thead>
    <tr>
      <td></td>
      <th scope="col">99 %</th>
      <th scope="col">${texts.engine.largest}</th>
    </tr>
  </thead>
  <tbody>
    ${rows.map(
      ({ of, percentile, largest }) => html`<tr>
        <th scope="row">${worded(of)}</th>
        <td>${percentile}</td>
        <td>${largest}</td>
      </tr>`,
    )}
  </tbody>
</table>`;
