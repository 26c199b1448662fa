/** The slider of the support factor α. A whole drag is one undo step. */
import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { RANGES } from '../../document/generated/settings';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';

export function alphaSlider(value: number, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const [least, most] = RANGES.shape_factor;
  const set = (event: Event, sliding: boolean) => {
    event.stopPropagation();
    const to = Number((event.target as HTMLInputElement).value);
    const type = sliding ? 'setting-slid' : 'setting-set';
    dispatch({ type, setting: { name: 'shape_factor', value: to } });
  };
  return html`<input
    type="range"
    class="slider"
    aria-label="Support factor α"
    min=${least}
    max=${most}
    step="0.01"
    .value=${live(String(value))}
    ?disabled=${model.readonly}
    @input=${(event: Event) => set(event, (event.target as Element).matches(':active'))}
    @change=${(event: Event) => set(event, false)}
  />`;
}
