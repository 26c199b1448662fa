/** The card of tools. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import type { ToolName } from '../tools/machine';
import { commandButton } from './command_button';

/** The tools in their order, with their words on phones. */
const TOOLS = [
  ['select', 'Move'],
  ['point', 'Point'],
  ['bar', 'Bar'],
  ['polygon', 'Polygon'],
  ['lasso', 'Lasso'],
  ['brush', 'Brush'],
  ['hand', 'Pan'],
  ['lens', 'Lens'],
] as const satisfies readonly (readonly [ToolName, string])[];

export function toolStrip(model: EditorModel, dispatch: Dispatch): TemplateResult {
  return html`<div class="tools card" part="tools" role="group" aria-label="Tools">
    ${TOOLS.map(([name, caption]) => commandButton(name, model, dispatch, { caption, pressed: model.tool === name }))}
    <span class="sheet-switch">
      ${commandButton('settings', model, dispatch, { caption: 'Bend', pressed: model.settings })}
    </span>
  </div>`;
}
