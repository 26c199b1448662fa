/** All settings of the project, each with a sentence on what it does to the picture. */

import { html, nothing, type TemplateResult } from 'lit-html';
import { modeOf } from '../../document/bending';
import { RANGES } from '../../document/generated/settings';
import { type Setting, settingsOf } from '../../document/settings';
import type { Dispatch, NumberChange } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import type { Texts } from '../../texts/texts';
import { type FieldLook, numberField } from '../number_field';
import { segment } from '../segment';
import { alphaSlider, slider } from './slider';

type NumberName = keyof typeof RANGES | 'threshold';

const NUMBERS = {
  shape_factor: { step: 0.05, digits: 2 },
  degree: { step: 1, digits: 0 },
  samples: { step: 1000, digits: 0 },
  density: { step: 10, digits: 0 },
  threshold: { step: 0.05, digits: 2 },
} as const satisfies Record<NumberName, Pick<FieldLook, 'step' | 'digits'>>;

const labelsOf = ({ settings }: Texts): Readonly<Record<NumberName, string>> => ({
  shape_factor: 'α',
  degree: 'n',
  samples: settings.points,
  density: settings.atLeast,
  threshold: settings.opacity,
});

const rangeOf = (name: NumberName): readonly [least: number, most: number] =>
  name === 'threshold' ? [0.01, 1] : RANGES[name];

export function settingsPage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { project } = model.document;
  const now = settingsOf(project);
  const { settings: words } = model.texts;
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
      words.motion,
      words.motionNotes[modeOf(project)],
      choice(
        words.motion,
        [
          ['rigid', words.rigid],
          ['harmonic', words.byHand],
        ],
        modeOf(project),
        (mode) => dispatch({ type: 'pose-mode-chosen', mode }),
      ),
    )}
    ${setting(words.density, words.densityNote, number('density', now.density))}
    ${setting(
      words.shapeFactor,
      words.shapeFactorNote,
      html`${alphaSlider(now.shape_factor, model, dispatch)}
      ${number('shape_factor', now.shape_factor)}`,
    )}
    ${setting(
      words.support,
      words.supportNotes[now.support],
      choice(
        words.support,
        [
          ['smooth', words.smooth],
          ['paper', words.paper],
        ],
        now.support,
        (value) => set({ name: 'support', value }),
      ),
    )}
    ${setting(
      words.continuity,
      words.continuityNotes[now.continuity],
      choice(
        words.continuity,
        [
          ['exact', words.exact],
          ['c2', 'C²'],
        ],
        now.continuity,
        (value) => set({ name: 'continuity', value }),
      ),
    )}
    ${setting(words.degree, words.degreeNote, number('degree', now.degree))}
    ${setting(
      words.filling,
      words.fillingNote,
      choice(
        words.filling,
        [
          ['line', words.line],
          ['half', words.half],
        ],
        now.filling,
        (value) => set({ name: 'filling', value }),
      ),
    )}
    ${setting(
      words.blend,
      words.blendNotes[now.blend],
      choice(
        words.blend,
        [
          ['linear', words.linear],
          ['rigid', words.rigid],
        ],
        now.blend,
        (value) => set({ name: 'blend', value }),
      ),
    )}
    ${setting(words.samples, words.samplesNote, number('samples', now.samples))}
    ${
      now.threshold === null
        ? nothing
        : setting(words.threshold, words.thresholdNote, threshold(now.threshold, model, dispatch))
    }
    <div class="presets">
      ${preset(words.asInPaper, 'paper', model, dispatch)} ${preset(words.asInEditor, 'editor', model, dispatch)}
    </div>`;
}

/** While it has the focus, the stage shows the outline of the bending part. */
function threshold(value: number, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const show = (on: boolean) => () => dispatch({ type: 'outline-shown', on });
  const look = {
    name: 'threshold',
    label: model.texts.settings.threshold,
    range: rangeOf('threshold'),
  } as const;
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
  const look: FieldLook = {
    ...NUMBERS[name],
    label: labelsOf(model.texts)[name],
    name,
    unit: '',
    least,
    most,
    digitKeys: true,
  };
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
