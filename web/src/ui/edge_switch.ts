/** Whether the lasso snaps to edges of the picture: beside its hint, and beside its drawing. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';

export const edgeSwitch = (model: EditorModel, dispatch: Dispatch): TemplateResult => html`<button
  type="button"
  class="edge-switch"
  part="button"
  role="switch"
  aria-checked=${String(model.edgeSnapping)}
  aria-busy=${String(model.edgesPending)}
  data-tip=${model.texts.hints.snapToEdgesTip}
  @click=${() => dispatch({ type: 'edge-snapping-switched', on: !model.edgeSnapping })}
>
  ${model.texts.hints.snapToEdges}
</button>`;
