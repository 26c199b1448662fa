/** The card of tools. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { TOOL_NAMES } from '../tools/machine';
import { commandButton } from './command_button';

export function toolStrip(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { tools: words } = model.texts;
  return html`<div class="tools card" part="tools" role="group" aria-label=${words.label}>
    ${TOOL_NAMES.map((name) => commandButton(name, model, dispatch, { caption: words[name], pressed: model.tool === name }))}
    <span class="sheet-switch">
      ${commandButton('settings', model, dispatch, { caption: words.bend, pressed: model.settings })}
    </span>
  </div>`;
}
