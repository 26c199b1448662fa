/** The bar of the brush: its effect, its size and strength, and the way back from all that it has done. */

import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { modeOf } from '../document/bending';
import { BRUSH_STRENGTHS, type BrushState } from '../editor/brush_state';
import { keyHint } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import type { Texts } from '../texts/texts';
import { BRUSH_KINDS, type BrushKind } from '../tools/brush_kinds';
import { type IconName, icon } from './icons';

const ICONS: Readonly<Record<BrushKind, IconName>> = {
  push: 'push',
  pinch: 'pinch',
  bloat: 'bloat',
  smooth: 'smooth',
  restore: 'reset',
  stiffen: 'stiffen',
};

export function brushBar(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  if (!model.brush || model.readonly || model.preview || !model.picture) return nothing;
  const { settings, size, sizes, holding } = model.brush;
  const { kind, strength, used } = settings;
  const { brush: texts } = model.texts;
  const set = (change: Partial<BrushState>) => dispatch({ type: 'brush-set', change });
  const stiffens = kind === 'stiffen';
  const softOnly = stiffens && modeOf(model.document.project) !== 'rigid';
  return html`<div class="brush-bar card" part="notice" role="group" aria-label=${texts.label}>
    <div class="segments kinds" role="group" aria-label=${texts.effect}>
      ${BRUSH_KINDS.map((other) => kindButton(other, other === kind, texts, () => set({ kind: other })))}
    </div>
    ${stiffens ? eraser(settings, model, set) : nothing}
    ${option(texts.size, texts.sizeLabel, 'size', size, sizes, (size) => set({ size }))}
    ${option(texts.strength, texts.strengthLabel, 'strength', strength, BRUSH_STRENGTHS, (strength) => set({ strength }))}
    ${clear(model, stiffens, dispatch)}
    ${holding ? words(texts.holding) : softOnly ? rigidOnly(texts, dispatch) : used.includes(kind) ? nothing : words(hintOf(kind, model))}
  </div>`;
}

/** The name is shown with the chosen one. */
const kindButton = (
  kind: BrushKind,
  chosen: boolean,
  { tips, kinds }: Texts['brush'],
  choose: () => void,
): TemplateResult => html`<button
  type="button"
  class="button segment kind"
  part="button"
  data-brush=${kind}
  data-tip=${tips[kind]}
  aria-label=${kinds[kind]}
  aria-pressed=${String(chosen)}
  @click=${() => !chosen && choose()}
>
  ${icon(ICONS[kind])}${chosen ? html`<span class="name" aria-hidden="true">${kinds[kind]}</span>` : nothing}
</button>`;

const eraser = (
  { erases }: BrushState,
  { platform, texts }: EditorModel,
  set: (change: Partial<BrushState>) => void,
): TemplateResult => html`<button
  type="button"
  class="button toggle erase"
  part="button"
  data-tip=${texts.brush.eraseTip}
  data-keys=${keyHint('brush-erase', platform, texts)}
  aria-label=${texts.brush.erase}
  aria-pressed=${String(erases)}
  @click=${() => set({ erases: !erases })}
>
  ${icon('eraser')}
</button>`;

function clear(
  { document, texts: { brush } }: EditorModel,
  stiffens: boolean,
  dispatch: Dispatch,
): TemplateResult {
  const { stiffness, displacement } = document.project;
  return html`<button
    type="button"
    class="button clear"
    part="button"
    data-tip=${stiffens ? brush.clearStiffnessTip : brush.clearStrokesTip}
    aria-label=${stiffens ? brush.clearStiffness : brush.clearStrokes}
    ?disabled=${(stiffens ? stiffness : displacement) === undefined}
    @click=${() => dispatch({ type: stiffens ? 'stiffness-cleared' : 'displacement-cleared' })}
  >
    ${icon('remove')}
  </button>`;
}

/** A finger has no Alt. */
const hintOf = (kind: BrushKind, { press, texts }: EditorModel): string => {
  const { hints, altHints } = texts.brush;
  return altHints[kind] && press === 'click'
    ? texts.names.sentences([hints[kind], altHints[kind]])
    : hints[kind];
};

const words = (text: string): TemplateResult => html`<p class="words">${text}</p>`;

const option = (
  word: string,
  label: string,
  name: 'size' | 'strength',
  value: number,
  { least, most }: { readonly least: number; readonly most: number },
  choose: (value: number) => void,
): TemplateResult => html`<label class="option">
  <span>${word}</span>
  <input
    type="range"
    name=${name}
    aria-label=${label}
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

const rigidOnly = (texts: Texts['brush'], dispatch: Dispatch): TemplateResult => html`<p class="words">
  ${texts.rigidOnly}
  <button
    type="button"
    class="button toggle"
    part="button"
    @click=${() => dispatch({ type: 'pose-mode-chosen', mode: 'rigid' })}
  >
    ${texts.bendRigidly}
  </button>
</p>`;
