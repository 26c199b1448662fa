/** The slider of a setting. A whole drag is one undo step. */
import { html, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { RANGES } from '../../document/generated/settings';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';

export interface SliderLook {
  readonly name: 'shape_factor' | 'threshold';
  readonly label: string;
  readonly range: readonly [least: number, most: number];
}

export function slider(
  { name, label, range: [least, most] }: SliderLook,
  value: number,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const set = (event: Event, sliding: boolean) => {
    event.stopPropagation();
    const to = Number((event.target as HTMLInputElement).value);
    const type = sliding ? 'setting-slid' : 'setting-set';
    dispatch({ type, setting: { name, value: to } });
  };
  return html`<input
    type="range"
    class="slider"
    aria-label=${label}
    min=${least}
    max=${most}
    step="0.01"
    .value=${live(String(value))}
    ?disabled=${model.readonly}
    @pointerdown=${(event: Event) => (event.currentTarget as HTMLElement).focus()}
    @input=${(event: Event) => set(event, (event.target as Element).matches(':active'))}
    @change=${(event: Event) => set(event, false)}
  />`;
}

/** The slider of the support factor α. */
export const alphaSlider = (value: number, model: EditorModel, dispatch: Dispatch): TemplateResult =>
  slider(
    { name: 'shape_factor', label: model.texts.settings.shapeFactor, range: RANGES.shape_factor },
    value,
    model,
    dispatch,
  );
