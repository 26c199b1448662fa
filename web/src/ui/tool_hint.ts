/**
 * A hint over the picture: the use of the current tool, or the tool to choose while there are no handles. A picture
 * without handles gets some by the button in it.
 */
import { html, nothing, type TemplateResult } from 'lit-html';
import { ringsOf } from '../document/domain';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import type { ToolName } from '../tools/machine';
import { edgeSwitch } from './edge_switch';
import { icon } from './icons';

export function toolHint(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { draft, document, picture } = model;
  // A notice with an action stays until it is answered, so hints appear above it.
  const silent = !model.notice || model.notice.action !== undefined;
  // The bar of the brush is shown.
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

/** Tools available to a person who has not drawn anything yet. */
const BEGINNERS: readonly ToolName[] = ['select', 'point'];

const suggestButton = (model: EditorModel, dispatch: Dispatch): TemplateResult => html`<button
  type="button"
  class="primary"
  ?disabled=${!model.canRun('suggest')}
  @click=${() => dispatch({ type: 'command-run', command: 'suggest' })}
>
  ${icon('suggest')}${model.texts.commands.suggest}
</button>`;

function wordsOf({ press, document, texts }: EditorModel): Partial<Record<ToolName, string>> {
  const { hints } = texts;
  const lines = {
    bar: hints.bar[press],
    polygon: hints.polygon[press],
    lasso: ringsOf(document.project).length > 0 ? hints.lassoAgain : hints.lasso[press],
  };
  if (document.project.handles.length > 0) return lines;
  return { ...lines, select: hints.select[press], point: hints.point[press] };
}
