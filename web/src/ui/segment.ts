/** A choice as a row of buttons, of which one is pressed. */
import { html, type TemplateResult } from 'lit-html';

export const segment = (
  word: string,
  chosen: boolean,
  disabled: boolean,
  choose: () => void,
): TemplateResult =>
  html`<button
    type="button"
    class="button segment"
    part="button"
    aria-pressed=${String(chosen)}
    ?disabled=${disabled}
    @click=${() => !chosen && choose()}
  >
    ${word}
  </button>`;
