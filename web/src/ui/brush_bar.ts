/** The bar of the brush: whether it paints or erases, its size and strength, and the way back to a soft picture. */
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { modeOf } from '../document/bending';
import { BRUSH_SIZES, BRUSH_STRENGTHS, type BrushState } from '../editor/brush_state';
import { COMMANDS, keyHint } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { icon } from './icons';
import { segment } from './segment';

export function brushBar(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  if (!model.brush || model.readonly || model.preview || !model.picture) return nothing;
  const { project } = model.document;
  const { settings } = model.brush;
  const set = (change: Partial<BrushState>) => dispatch({ type: 'brush-set', change });
  return html`<div class="brush-bar card" part="notice" role="group" aria-label="Brush">
    <div class="segments" role="group" aria-label="What the brush does">
      ${segment('Paint', !settings.erases, false, () => set({ erases: false }))}
      ${segment('Erase', settings.erases, false, () => set({ erases: true }))}
    </div>
    ${option('Size', 'size', settings.size, BRUSH_SIZES, (size) => set({ size }))}
    ${option('Strength', 'strength', settings.strength, BRUSH_STRENGTHS, (strength) => set({ strength }))}
    <button
      type="button"
      class="button clear"
      part="button"
      data-tip="Make the picture soft again"
      aria-label="Clear stiffness"
      ?disabled=${project.stiffness === undefined}
      @click=${() => dispatch({ type: 'stiffness-cleared' })}
    >
      ${icon('remove')}
    </button>
    ${modeOf(project) === 'rigid' ? nothing : rigidOnly(dispatch)}
  </div>`;
}

const option = (
  label: string,
  name: 'size' | 'strength',
  value: number,
  { least, most }: { readonly least: number; readonly most: number },
  choose: (value: number) => void,
): TemplateResult => html`<label class="option">
  <span>${label}</span>
  <input
    type="range"
    name=${name}
    aria-label="Brush ${name} (%)"
    min=${least}
    max=${most}
    .value=${live(String(value))}
    @input=${(event: Event) => choose(kept(event))}
    @change=${kept}
  />
  <output>${value} %</output>
</label>`;

/** The value of an input, kept from the page: it is no edit of the document. */
function kept(event: Event): number {
  event.stopPropagation();
  return Number((event.target as HTMLInputElement).value);
}

const rigidOnly = (dispatch: Dispatch): TemplateResult => html`<p class="words">
  Stiffness counts in rigid bending only.
  <button
    type="button"
    class="button toggle"
    part="button"
    @click=${() => dispatch({ type: 'pose-mode-chosen', mode: 'rigid' })}
  >
    Bend rigidly
  </button>
</p>`;

/** The keys of the brush, for the hint. */
export const brushKeys = (platform: string): string =>
  `${keyHint('brush-smaller', platform)} and ${keyHint('brush-larger', platform)} change its size, ` +
  `${keyHint('brush-erase', platform)} or Alt ${COMMANDS['brush-erase'].label.toLowerCase()}`;
