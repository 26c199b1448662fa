/** The bar of the brush: its effect, its size and strength, and the way back from all that it has done. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { modeOf } from '../document/bending';
import { BRUSH_STRENGTHS, type BrushState } from '../editor/brush_state';
import { keyHint } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { BRUSH_KINDS, type BrushKind } from '../tools/brush_kinds';
import { type IconName, icon } from './icons';

interface Look {
  readonly label: string;
  readonly tip: string;
  readonly icon: IconName;
  /** For a person who has not used it yet. */
  readonly hint: string;
  /** The effect with Alt. */
  readonly alt?: string;
}

const LOOKS: Readonly<Record<BrushKind, Look>> = {
  push: {
    label: 'Push',
    tip: 'Push: drag the picture along',
    icon: 'push',
    hint: 'Drag to push the picture along.',
    alt: 'Alt restores it.',
  },
  pinch: {
    label: 'Pinch',
    tip: 'Pinch: draw the picture together',
    icon: 'pinch',
    hint: 'Press or drag to draw the picture together.',
    alt: 'Alt bloats.',
  },
  bloat: {
    label: 'Bloat',
    tip: 'Bloat: spread the picture out',
    icon: 'bloat',
    hint: 'Press or drag to spread the picture out.',
    alt: 'Alt pinches.',
  },
  smooth: {
    label: 'Smooth',
    tip: 'Smooth: level places that the brush has moved',
    icon: 'smooth',
    hint: 'Drag to level places that the brush has moved.',
  },
  restore: {
    label: 'Restore',
    tip: 'Restore: take back strokes of the brush',
    icon: 'reset',
    hint: 'Drag to take back strokes of the brush.',
    alt: 'Alt pushes.',
  },
  stiffen: {
    label: 'Stiffen',
    tip: 'Stiffen: keep the form of places',
    icon: 'stiffen',
    hint: 'Drag over places that are to keep their form.',
    alt: 'Alt erases.',
  },
};

export function brushBar(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  if (!model.brush || model.readonly || model.preview || !model.picture) return nothing;
  const { settings, size, sizes, holding } = model.brush;
  const { kind, strength, used } = settings;
  const set = (change: Partial<BrushState>) => dispatch({ type: 'brush-set', change });
  const stiffens = kind === 'stiffen';
  const softOnly = stiffens && modeOf(model.document.project) !== 'rigid';
  return html`<div class="brush-bar card" part="notice" role="group" aria-label="Brush">
    <div class="segments kinds" role="group" aria-label="Effect of the brush">
      ${BRUSH_KINDS.map((other) => kindButton(other, other === kind, () => set({ kind: other })))}
    </div>
    ${stiffens ? eraser(settings, model.platform, set) : nothing}
    ${option('Size', 'size', size, sizes, (size) => set({ size }))}
    ${option('Strength', 'strength', strength, BRUSH_STRENGTHS, (strength) => set({ strength }))}
    ${clear(model, stiffens, dispatch)}
    ${holding ? words('Arrows push, Enter lets go.') : softOnly ? rigidOnly(dispatch) : used.includes(kind) ? nothing : words(hintOf(kind, model.press))}
  </div>`;
}

/** The name is shown with the chosen one. */
const kindButton = (kind: BrushKind, chosen: boolean, choose: () => void): TemplateResult => html`<button
  type="button"
  class="button segment kind"
  part="button"
  data-brush=${kind}
  data-tip=${LOOKS[kind].tip}
  aria-label=${LOOKS[kind].label}
  aria-pressed=${String(chosen)}
  @click=${() => !chosen && choose()}
>
  ${icon(LOOKS[kind].icon)}${chosen ? html`<span class="name" aria-hidden="true">${LOOKS[kind].label}</span>` : nothing}
</button>`;

const eraser = (
  { erases }: BrushState,
  platform: string,
  set: (change: Partial<BrushState>) => void,
): TemplateResult => html`<button
  type="button"
  class="button toggle erase"
  part="button"
  data-tip="Erase stiffness"
  data-keys=${keyHint('brush-erase', platform)}
  aria-label="Erase"
  aria-pressed=${String(erases)}
  @click=${() => set({ erases: !erases })}
>
  ${icon('eraser')}
</button>`;

function clear({ document }: EditorModel, stiffens: boolean, dispatch: Dispatch): TemplateResult {
  const { stiffness, displacement } = document.project;
  return html`<button
    type="button"
    class="button clear"
    part="button"
    data-tip=${stiffens ? 'Make the picture soft again' : 'Take back all that the brush has moved'}
    aria-label=${stiffens ? 'Clear stiffness' : 'Clear the strokes of the brush'}
    ?disabled=${(stiffens ? stiffness : displacement) === undefined}
    @click=${() => dispatch({ type: stiffens ? 'stiffness-cleared' : 'displacement-cleared' })}
  >
    ${icon('remove')}
  </button>`;
}

/** A finger has no Alt. */
const hintOf = (kind: BrushKind, press: EditorModel['press']): string => {
  const { hint, alt } = LOOKS[kind];
  return alt && press === 'click' ? `${hint} ${alt}` : hint;
};

const words = (text: string): TemplateResult => html`<p class="words">${text}</p>`;

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
