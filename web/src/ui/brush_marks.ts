/** The rim of the brush under the pointer, or at the crosshair of the keyboard. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';

export function brushMarks({ brush, camera, preview }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!brush?.at || preview) return nothing;
  const [x, y] = toStage(camera, brush.at);
  const radius = brush.radius * camera.scale;
  return svg`<g class="brush ${brush.erasing ? 'erasing' : ''}">
    <circle class="under" cx=${x} cy=${y} r=${radius}/><circle cx=${x} cy=${y} r=${radius}/>
  </g>`;
}
