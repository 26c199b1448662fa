/** The card of tools. */
import { html, type TemplateResult } from 'lit';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import type { ToolName } from '../tools/machine';
import { commandButton } from './command_button';

const TOOL_ORDER: readonly ToolName[] = ['select', 'point', 'bar', 'polygon', 'lasso', 'hand'];

export function toolStrip(model: EditorModel, dispatch: Dispatch): TemplateResult {
  return html`<div class="tools card" part="tools" role="group" aria-label="Tools">
    ${TOOL_ORDER.map((name) => commandButton(name, model, dispatch, { pressed: model.tool === name }))}
    <span class="sheet-switch">
      ${commandButton('settings', model, dispatch, { pressed: model.settings })}
    </span>
  </div>`;
}
