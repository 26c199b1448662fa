/**
 * A hint over the picture: the use of the current tool, or the tool to choose while there are no handles. A picture
 * without handles gets some by the button in it.
 */
import { html, nothing, type TemplateResult } from 'lit-html';
import { ringsOf } from '../document/domain';
import { COMMANDS } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import type { ToolName } from '../tools/machine';
import { edgeSwitch } from './edge_switch';
import { icon } from './icons';

export function toolHint(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { draft, document, picture } = model;
  // A notice with an action stays until it is answered, so hints appear above it.
  const silent = !model.notice || model.notice.action !== undefined;
  // The bar of the brush is there.
  const idle = !model.brush && !model.readonly && silent && !model.hint && !model.preview;
  if (!idle || picture === null || draft !== null || document.selection.length > 0) return nothing;
  const words = wordsOf(model)[model.tool];
  if (words === undefined) return nothing;
  const suggests = document.project.handles.length === 0 && BEGINNERS.includes(model.tool);
  const acts = suggests || model.tool === 'lasso';
  return html`<p class="hint ${acts ? 'suggests' : ''}" part="hint">
    <span>${words}</span>${suggests ? suggestButton(model, dispatch) : nothing}
    ${model.tool === 'lasso' ? edgeSwitch(model, dispatch) : nothing}
  </p>`;
}

/** Tools that a person has who has not drawn anything yet. */
const BEGINNERS: readonly ToolName[] = ['select', 'point'];

const suggestButton = (model: EditorModel, dispatch: Dispatch): TemplateResult => html`<button
  type="button"
  class="primary"
  ?disabled=${!model.canRun('suggest')}
  @click=${() => dispatch({ type: 'command-run', command: 'suggest' })}
>
  ${icon('suggest')}${COMMANDS.suggest.label}
</button>`;

function wordsOf({ press, document }: EditorModel): Partial<Record<ToolName, string>> {
  const lines = {
    bar: `Drag a bar, or ${press} its corners`,
    polygon: `Draw a polygon: ${press} its corners`,
    lasso:
      ringsOf(document.project).length > 0
        ? 'Drag a corner of the selection, or draw around another part'
        : `Draw around the part that bends: drag, or ${press} corners`,
  };
  if (document.project.handles.length > 0) return lines;
  return {
    ...lines,
    select: `Take the point tool, and ${press} the picture`,
    point:
      press === 'tap'
        ? 'Tap the picture where you want to hold it'
        : 'Click the picture where you want to hold it',
  };
}
