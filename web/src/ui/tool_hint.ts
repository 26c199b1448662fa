/** A hint over the picture: the use of the current tool, or the tool to choose while there are no handles. */
import { html, nothing, type TemplateResult } from 'lit';
import type { EditorModel } from '../editor/view_model';
import type { ToolName } from '../tools/machine';

export function toolHint(model: EditorModel): TemplateResult | typeof nothing {
  const { draft, document, picture } = model;
  // A notice with an action stays until it is answered, so hints appear above it.
  const silent = !model.notice || model.notice.action !== undefined;
  const idle = !model.readonly && silent && !model.hint && !model.preview;
  if (!idle || picture === null || draft !== null || document.selection.length > 0) return nothing;
  const words = wordsOf(model)[model.tool];
  return words === undefined ? nothing : html`<p class="hint" part="hint">${words}</p>`;
}

function wordsOf({ press, document }: EditorModel): Partial<Record<ToolName, string>> {
  const lines = {
    bar: `Drag a bar, or ${press} its corners`,
    polygon: `Draw a polygon: ${press} its corners`,
    lasso: `Draw around the part that bends: drag, or ${press} corners`,
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
