/** The picture's own rectangle, which bounds the export. It appears when something is bent beyond it. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';

/** Dark and light dashes alternate, so that one of them is visible on any picture and background. */
export function frame({ beyond, picture, camera }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!beyond || !picture) return nothing;
  const [x, y] = toStage(camera, [0, 0]);
  const [right, bottom] = toStage(camera, [picture.width, picture.height]);
  const rectangle = (name: string) =>
    svg`<rect class=${name} x=${x} y=${y} width=${right - x} height=${bottom - y}/>`;
  return svg`<g class="frame">${rectangle('pale')}${rectangle('dashes')}</g>`;
}
