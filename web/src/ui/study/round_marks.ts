/** A round of Algorithm 1 on the stage: the sites before it, and the points where it inserts. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import { roundModel } from '../../editor/rounds_model';
import type { EditorModel } from '../../editor/view_model';
import { toStage } from '../../geometry/camera';
import type { Vec } from '../../geometry/vec';
import { pathOf } from './figure';

/** Length of the pieces of a bent path, image pixels at rest. */
const STEP = 12;

export function roundMarks(model: EditorModel): SVGTemplateResult | typeof nothing {
  const { camera, study } = model;
  const shown = study.page === 'rounds' && !model.preview ? roundModel(study) : null;
  if (!shown) return nothing;
  const { sites, round } = shown;
  const virtual = sites.filter(({ handle }) => handle === -1).map(({ rest }) => [rest]);
  const posed = (lines: readonly (readonly Vec[])[], step: number) =>
    model.posedLines(lines, step).map((line) => line.map((vertex) => toStage(camera, vertex)));
  const dots = posed(virtual, 1).flat();
  const ways = posed(
    round.points.map(({ path }) => path),
    STEP,
  );
  const way = ways.map((line) => pathOf(line)).join('');
  const ends = ways.flatMap((line) => line.slice(-1));
  return svg`<g class="round">
    <path class="way pale" d=${way}/><path class="way" d=${way}/>
    ${dots.map(([x, y]) => svg`<circle class="inserted" cx=${x.toFixed(1)} cy=${y.toFixed(1)} r="4"/>`)}
    ${ends.map(([x, y]) => svg`<circle class="entering pale" cx=${x} cy=${y} r="8"/><circle class="entering" cx=${x} cy=${y} r="8"/>`)}
  </g>`;
}
