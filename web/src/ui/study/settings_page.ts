/** All settings of the project, each with a sentence on what it does to the picture. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { modeOf } from '../../document/bending';
import { RANGES } from '../../document/generated/settings';
import { type Setting, settingsOf } from '../../document/settings';
import type { Dispatch, NumberChange } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import { type FieldLook, numberField } from '../number_field';
import { segment } from '../segment';
import { alphaSlider, slider } from './slider';

type NumberName = keyof typeof RANGES | 'threshold';

const NUMBERS = {
  shape_factor: { label: 'α', step: 0.05, digits: 2 },
  degree: { label: 'n', step: 1, digits: 0 },
  samples: { label: 'Points', step: 1000, digits: 0 },
  density: { label: 'At least', step: 10, digits: 0 },
  threshold: { label: 'Opacity', step: 0.05, digits: 2 },
} as const satisfies Record<NumberName, Pick<FieldLook, 'label' | 'step' | 'digits'>>;

const rangeOf = (name: NumberName): readonly [least: number, most: number] =>
  name === 'threshold' ? [0.01, 1] : RANGES[name];

export function settingsPage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { project } = model.document;
  const now = settingsOf(project);
  const set = (setting: Setting) => dispatch({ type: 'setting-set', setting });
  const number = (name: NumberName, value: number) => numberSetting(name, value, model, dispatch);
  const choice = <V extends string>(
    label: string,
    values: readonly (readonly [V, string])[],
    chosen: V,
    choose: (value: V) => void,
  ) => html`<div class="segments" role="group" aria-label=${label}>
    ${values.map(([value, word]) => segment(word, value === chosen, model.readonly, () => choose(value)))}
  </div>`;
  return html`
    ${setting(
      'Motion of virtual handles',
      modeOf(project) === 'rigid'
        ? 'They keep the form of the picture: limbs bend, and handles turn by themselves.'
        : 'Harmonic fields mix the motions of your handles, as in the paper (eq. 4). You turn the handles.',
      choice(
        'Motion of virtual handles',
        [
          ['rigid', 'Rigid'],
          ['harmonic', 'By hand'],
        ],
        modeOf(project),
        (mode) => dispatch({ type: 'pose-mode-chosen', mode }),
      ),
    )}
    ${setting(
      'Virtual handles',
      'More of them bend the picture more finely, and a drag reaches less far. With 0, the paper’s algorithm decides.',
      number('density', now.density),
    )}
    ${setting(
      'Support factor α',
      'How far each handle reaches. At 0 it reaches little beyond its own cell, and bends are tight. At 1 it reaches as far as it may, and bends are soft.',
      html`${alphaSlider(now.shape_factor, model, dispatch)}
      ${number('shape_factor', now.shape_factor)}`,
    )}
    ${setting(
      'Rule of supports',
      now.support === 'smooth'
        ? 'Supports of virtual handles overlap. The picture bends evenly.'
        : 'Supports end at the next handle, virtual ones included (eq. 3). The picture bends in smaller steps.',
      choice(
        'Rule of supports',
        [
          ['smooth', 'Smooth'],
          ['paper', 'Paper'],
        ],
        now.support,
        (value) => set({ name: 'support', value }),
      ),
    )}
    ${setting(
      'Continuity',
      now.continuity === 'c2'
        ? 'Bends are smooth behind corners and around holes too: two continuous derivatives. Holes get virtual handles.'
        : 'The picture may show a fine crease behind a hole, where two ways around it are equally long.',
      choice(
        'Continuity',
        [
          ['exact', 'Exact'],
          ['c2', 'C²'],
        ],
        now.continuity,
        (value) => set({ name: 'continuity', value }),
      ),
    )}
    ${setting(
      'Degree n of the falloff',
      'At 5 the bend between two handles is short, and parts near them move as one. A higher degree spreads it over the way.',
      number('degree', now.degree),
    )}
    ${setting(
      'Filling of the falloff',
      'How the falloff goes on between its ends, from degree 7 on. “Line” falls evenly. “Half” keeps a step, where parts follow two handles by halves.',
      choice(
        'Filling of the falloff',
        [
          ['line', 'Line'],
          ['half', 'Half'],
        ],
        now.filling,
        (value) => set({ name: 'filling', value }),
      ),
    )}
    ${setting(
      'Blend',
      now.blend === 'rigid'
        ? 'Turns blend to turns: a part between two opposite turns keeps its size.'
        : 'Motions are averaged, as in the paper (eq. 1): a part between two opposite turns shrinks.',
      choice(
        'Blend',
        [
          ['linear', 'Linear'],
          ['rigid', 'Rigid'],
        ],
        now.blend,
        (value) => set({ name: 'blend', value }),
      ),
    )}
    ${setting(
      'Samples',
      'The points that carry the picture. More of them draw bends more finely, and solving takes longer.',
      number('samples', now.samples),
    )}
    ${
      now.threshold === null
        ? nothing
        : setting(
            'Least opacity',
            'What is more transparent than this does not bend. A lower number takes soft edges and thin hair along.',
            threshold(now.threshold, model, dispatch),
          )
    }
    <div class="presets">
      ${preset('As in the paper', 'paper', model, dispatch)} ${preset('As in the editor', 'editor', model, dispatch)}
    </div>`;
}

/** While it has the focus, the stage shows the outline of the bending part. */
function threshold(value: number, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const show = (on: boolean) => () => dispatch({ type: 'outline-shown', on });
  const look = { name: 'threshold', label: 'Least opacity', range: rangeOf('threshold') } as const;
  return html`<div class="outlining" @focusin=${show(true)} @focusout=${show(false)}>
    ${slider(look, value, model, dispatch)} ${numberSetting('threshold', value, model, dispatch)}
  </div>`;
}

const setting = (title: string, sentence: string, control: TemplateResult): TemplateResult =>
  html`<section class="setting">
    <h3>${title}</h3>
    <div class="control">${control}</div>
    <p class="faint">${sentence}</p>
  </section>`;

function numberSetting(
  name: NumberName,
  value: number,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const [least, most] = rangeOf(name);
  const look: FieldLook = { ...NUMBERS[name], name, unit: '', least, most, digitKeys: true };
  const set = (change: NumberChange) => {
    const to = 'to' in change ? change.to : Math.min(Math.max(value + change.by, least), most);
    dispatch({ type: 'setting-set', setting: { name, value: Number(to.toFixed(look.digits)) } });
  };
  return numberField(look, [value], set, model, dispatch);
}

const preset = (
  word: string,
  name: 'paper' | 'editor',
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult => html`<button
  type="button"
  class="button toggle"
  part="button"
  ?disabled=${model.readonly}
  @click=${() => dispatch({ type: 'preset-chosen', preset: name })}
>
  ${word}
</button>`;
