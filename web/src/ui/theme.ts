/** The button that switches between light and dark colours. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { icon } from './icons';

/** The colours that the button switches to. */
export const themeLabel = ({ dark, texts }: EditorModel): string =>
  dark ? texts.toolbar.lightColours : texts.toolbar.darkColours;

export function themeButton(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const label = themeLabel(model);
  return html`<button
    type="button"
    class="button theme"
    part="button"
    data-tip=${label}
    aria-label=${label}
    @click=${() => dispatch({ type: 'theme-switched' })}
  >
    ${icon(model.dark ? 'light' : 'dark')}
  </button>`;
}
