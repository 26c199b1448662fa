/** The picture by three methods, beside each other: the same handles in the same pose. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { VARIANTS } from '../../document/variants';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import type { VariantCanvases } from '../study_view';
import { saveButton } from './save_button';

export function comparePage(
  model: EditorModel,
  dispatch: Dispatch,
  canvases: VariantCanvases,
): TemplateResult {
  const { compare: words } = model.texts;
  return html`
    <p class="faint">${words.note}</p>
    <div class="variants">
      ${VARIANTS.map((variant) => {
        const refusal = model.study.refusals[variant];
        return html`<figure>
          <div class="variant" role="img" aria-label=${words.labels[variant]}>${canvases[variant]}</div>
          <figcaption>
            <h3>${words.names[variant]}</h3>
            <p class="faint">${words.notes[variant]}</p>
            ${refusal === null ? nothing : html`<p>${model.worded(refusal)}</p>`}
          </figcaption>
        </figure>`;
      })}
    </div>
    ${saveButton('compare', model.texts, dispatch)}`;
}
