/** The cells on the stage: the radii r_d and r_h of each (figure 2), and the sites. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import type { EditorModel } from '../../editor/view_model';
import { toStage } from '../../geometry/camera';
import type { Vec } from '../../geometry/vec';
import { cellPath } from '../overlays';
import { pathOf } from './figure';

export function cellMarks(model: EditorModel): SVGTemplateResult | typeof nothing {
  const { camera, study, overlays } = model;
  const sites = study.explained?.study?.sites;
  if (study.page !== 'cells' || !sites || model.preview) return nothing;
  const path = (lines: readonly (readonly Vec[])[]) =>
    model
      .posedLines(
        lines.filter(({ length }) => length > 1),
        Number.POSITIVE_INFINITY,
      )
      .map((line) => pathOf(line.map((vertex) => toStage(camera, vertex))))
      .join('');
  const nearest = path(sites.map(({ to_nearest }) => to_nearest));
  const farthest = path(sites.map(({ to_farthest }) => to_farthest));
  return svg`${overlays.cells ? nothing : svg`<path class="cell-border" d=${cellPath(model.borders, camera)}/>`}
    <g class="radii">
      <path class="pale" d=${nearest + farthest}/>
      <path class="of-nearest" d=${nearest}/><path class="of-farthest" d=${farthest}/>
    </g>`;
}
