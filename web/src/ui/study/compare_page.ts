/** The picture by three methods, beside each other: the same handles in the same pose. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { VARIANTS, type Variant } from '../../document/variants';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import type { VariantCanvases } from '../study_view';
import { saveButton } from './save_button';

export const VARIANT_TEXTS = {
  paper: ['Paper', 'Distances inside the shape, and harmonic fields. Turn the handles yourself.'],
  rigid: ['Rigid', 'The shape keeps its form as far as it can. Handles turn by themselves.'],
  plain: ['Plain distance', 'As the paper, but distances cross the gaps, so near parts move along.'],
} as const satisfies Record<Variant, readonly [title: string, note: string]>;

export function comparePage(
  model: EditorModel,
  dispatch: Dispatch,
  canvases: VariantCanvases,
): TemplateResult {
  return html`
    <p class="faint">Drag the handles of the picture. All three follow.</p>
    <div class="variants">
      ${VARIANTS.map((variant) => {
        const [title, note] = VARIANT_TEXTS[variant];
        const refusal = model.study.refusals[variant];
        return html`<figure>
          <div class="variant" role="img" aria-label="The picture by ${title.toLowerCase()}">${canvases[variant]}</div>
          <figcaption>
            <h3>${title}</h3>
            <p class="faint">${note}</p>
            ${refusal === null ? nothing : html`<p>${refusal}</p>`}
          </figcaption>
        </figure>`;
      })}
    </div>
    ${saveButton('compare', dispatch)}`;
}
