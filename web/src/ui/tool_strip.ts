/** The card of tools. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import type { ToolName } from '../tools/machine';
import { commandButton } from './command_button';

/** The tools in their order. */
const TOOLS = [
  'select',
  'point',
  'bar',
  'polygon',
  'lasso',
  'brush',
  'hand',
  'lens',
] as const satisfies readonly ToolName[];

export function toolStrip(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { tools: words } = model.texts;
  return html`<div class="tools card" part="tools" role="group" aria-label=${words.label}>
    ${TOOLS.map((name) => commandButton(name, model, dispatch, { caption: words[name], pressed: model.tool === name }))}
    <span class="sheet-switch">
      ${commandButton('settings', model, dispatch, { caption: words.bend, pressed: model.settings })}
    </span>
  </div>`;
}
