/** The lassoed domain: its rings on the original, and a veil over the rest. */
import { nothing, type SVGTemplateResult, svg } from 'lit';
import { ringsOf } from '../document/domain';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';

export function domainMarks({ document, picture, camera }: EditorModel): SVGTemplateResult | typeof nothing {
  const rings = ringsOf(document.project);
  if (!picture || rings.length === 0) return nothing;
  const path = rings.map((ring) => `M${ring.map((corner) => toStage(camera, corner)).join('L')}Z`).join('');
  const [left, top] = toStage(camera, [0, 0]);
  const [right, bottom] = toStage(camera, [picture.width, picture.height]);
  const all = `M${left},${top}H${right}V${bottom}H${left}Z`;
  return svg`<g class="domain">
    <path class="veil" fill-rule="evenodd" d="${all}${path}"/>
    <path class="pale" d=${path}/><path class="dashes" d=${path}/>
  </g>`;
}
