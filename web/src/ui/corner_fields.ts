/** The corners of a bar or polygon in the panel: how to add one, and the place of the focused one. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { LineHandle } from '../document/project';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { commandButton } from './command_button';
import { numberField, PLACE } from './number_field';

export function cornerFields({ posed }: LineHandle, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { corner, press, texts } = model;
  const at = corner === null ? undefined : posed[corner];
  const words = at
    ? texts.panel.corner((corner ?? 0) + 1, posed.length)
    : texts.panel.corners[press](posed.length);
  return html`<div class="row corners">
      <span class="faint" title=${texts.panel.cornersTip[press]}>${words}</span>
      ${commandButton('add-corner', model, dispatch)}
      ${at ? commandButton('remove-corner', model, dispatch) : nothing}
    </div>
    ${at ? place(at, words, model, dispatch) : nothing}`;
}

const place = (
  at: readonly [number, number],
  label: string,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult =>
  html`<div class="fields of-corner" role="group" aria-label=${label}>
    ${([0, 1] as const).map((axis) => {
      const look = {
        ...PLACE,
        name: axis === 0 ? 'corner-x' : 'corner-y',
        label: axis === 0 ? model.texts.panel.x : model.texts.panel.y,
      };
      return numberField(
        look,
        [at[axis]],
        (change) => dispatch({ type: 'corner-field-set', axis, change }),
        model,
        dispatch,
      );
    })}
  </div>`;
