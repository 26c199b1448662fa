/** The numbers of the selected handles, with buttons beside some of them. */

import { html, type TemplateResult } from 'lit-html';
import {
  anchor,
  DEPTHS,
  depthOf,
  isAutomatic,
  isLine,
  rotationOf,
  SCALES,
  scaleOf,
  type Turns,
} from '../document/handle';
import type { Handle } from '../document/project';
import { stiffnessOf } from '../document/stiffness';
import type { Dispatch, Field } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import type { Texts } from '../texts/texts';
import { commandButton } from './command_button';
import { type FieldLook, numberField, PLACE } from './number_field';

interface HandleField extends FieldLook {
  readonly name: Field;
  read(handle: Handle, turns: Turns): number;
}

const fieldsOf = ({ panel: words }: Texts): readonly HandleField[] => [
  { ...PLACE, name: 'x', label: words.x, read: (handle) => anchor(handle)[0] },
  { ...PLACE, name: 'y', label: words.y, read: (handle) => anchor(handle)[1] },
  { name: 'rotation', label: words.turn, unit: '°', step: 1, digits: 1, read: rotationOf },
  {
    name: 'scale',
    label: words.scale,
    unit: '×',
    step: 0.05,
    digits: 2,
    least: SCALES.least,
    most: SCALES.most,
    digitKeys: true,
    read: scaleOf,
  },
  {
    name: 'depth',
    label: words.depth,
    unit: '',
    step: 1,
    digits: 2,
    least: DEPTHS.least,
    most: DEPTHS.most,
    tip: words.depthTip(DEPTHS.least, DEPTHS.most),
    read: depthOf,
  },
];

const stiffnessField = ({ panel: words }: Texts): HandleField => ({
  name: 'stiffness',
  label: words.stiffness,
  unit: '',
  step: 0.1,
  digits: 2,
  least: 0,
  most: 1,
  digitKeys: true,
  tip: words.stiffnessTip,
  read: stiffnessOf,
});

export const fields = (
  selected: readonly Handle[],
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult => {
  const isRaised = (handle: Handle) => model.automaticDepths.get(handle.id) === depthOf(handle);
  const { auto, automaticDepth } = model.texts.panel;
  const automatic = selected.every(isRaised) ? { unit: auto, tip: automaticDepth } : {};
  const field = (own: HandleField) => {
    const look = own.name === 'depth' ? { ...own, ...automatic } : own;
    const numbers = selected.map((handle) => look.read(handle, model.turns));
    const input = numberField(
      look,
      numbers,
      (change) => dispatch({ type: 'field-set', field: look.name, change }),
      model,
      dispatch,
    );
    return besides(look, input, selected, model, dispatch);
  };
  const areStiff = selected.every(({ kind }) => kind === 'polygon');
  return html`<div class="fields">${[...fieldsOf(model.texts), ...(areStiff ? [stiffnessField(model.texts)] : [])].map(field)}</div>`;
};

/** A field with its buttons. */
function besides(
  { name }: HandleField,
  input: TemplateResult,
  selected: readonly Handle[],
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  if (name === 'rotation' && selected.some((handle) => !isLine(handle))) {
    return html`<div class="pair turn">${input} ${automaticToggle(selected, model, dispatch)}</div>`;
  }
  if (name !== 'depth') return input;
  return html`<div class="pair depth">
    ${input} ${commandButton('backward', model, dispatch)}
    ${commandButton('forward', model, dispatch)}
  </div>`;
}

/** Toggles automatic rotation of the selected points. If they differ, a press makes all of them automatic. */
function automaticToggle(
  selected: readonly Handle[],
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const points = selected.filter((handle) => !isLine(handle));
  const free = points.filter(isAutomatic).length;
  const all = free === points.length;
  const { panel: words } = model.texts;
  return html`<button
    type="button"
    class="button toggle"
    part="button"
    data-tip=${all ? words.turnsByItself : words.letTurn}
    aria-label=${words.autoTurn}
    aria-pressed=${all ? 'true' : free > 0 ? 'mixed' : 'false'}
    ?disabled=${model.readonly}
    @click=${() => dispatch({ type: 'automatic-rotation-switched', on: !all })}
  >
    ${words.auto}
  </button>`;
}
