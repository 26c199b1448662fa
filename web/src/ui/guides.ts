/** The guides that a moved handle lies on: thin lines across the stage. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';

export function guideLines({ guides, camera, stage }: EditorModel): SVGTemplateResult | typeof nothing {
  if (guides.length === 0) return nothing;
  const path = guides
    .map(({ axis, at }) => {
      const [x, y] = toStage(camera, [at, at]);
      return axis === 0 ? `M${x} 0V${stage.height}` : `M0 ${y}H${stage.width}`;
    })
    .join('');
  return svg`<g class="guides"><path class="pale" d=${path}/><path d=${path}/></g>`;
}
