/** Saves the figure of a page as SVG. */

import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import type { FigureName } from '../../editor/study_state';
import type { Texts } from '../../texts/texts';
import { icon } from '../icons';

export const saveButton = (
  figure: FigureName,
  { study }: Texts,
  dispatch: Dispatch,
): TemplateResult => html`<button
  type="button"
  class="button toggle save-figure"
  part="button"
  @click=${() => dispatch({ type: 'figure-asked', figure })}
>
  ${icon('export')}${study.saveAsSvg}
</button>`;
