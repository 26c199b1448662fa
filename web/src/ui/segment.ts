/** A choice as a row of buttons, of which one is pressed. */
import { html, type TemplateResult } from 'lit';
import type { EditorModel } from '../editor/view_model';

export const segment = (
  word: string,
  chosen: boolean,
  model: EditorModel,
  choose: () => void,
): TemplateResult =>
  html`<button
    type="button"
    class="button segment"
    part="button"
    aria-pressed=${String(chosen)}
    ?disabled=${model.readonly}
    @click=${() => !chosen && choose()}
  >
    ${word}
  </button>`;
