/** The card of tools. */
import { html, type TemplateResult } from 'lit';
import type { ToolName } from '../tools/machine';
import { commandButton } from './command_button';
import type { EditorActions, EditorModel } from './model';

const TOOL_ORDER: readonly ToolName[] = ['select', 'point', 'bar', 'polygon', 'lasso', 'hand'];

export function toolStrip(model: EditorModel, actions: EditorActions): TemplateResult {
  return html`<div class="tools card" part="tools" role="group" aria-label="Tools">
    ${TOOL_ORDER.map((name) => commandButton(name, model, actions, { pressed: model.tool === name }))}
    <span class="sheet-switch">
      ${commandButton('settings', model, actions, { pressed: model.settings })}
    </span>
  </div>`;
}
