/** Aims over the picture: the box of a drag, the crosshair of the keyboard, and presses that wait for their picture. */
import { nothing, type SVGTemplateResult, svg } from 'lit';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';

/** The box of a drag over empty space, in stage pixels. */
export function selectionBox({ box, camera }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!box) return nothing;
  const [x, y] = toStage(camera, box.min);
  const [right, bottom] = toStage(camera, box.max);
  return svg`<rect class="box" x=${x} y=${y} width=${right - x} height=${bottom - y}/>`;
}

/** Where the keyboard would place a handle. */
export function crosshair({ crosshair: at, camera }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!at) return nothing;
  const [x, y] = toStage(camera, at);
  return svg`<g class="crosshair" transform="translate(${x} ${y})">
    <path class="under" d="M-14 0H14M0 -14V14"/><path d="M-14 0H14M0 -14V14"/>
  </g>`;
}

/** The presses that wait: people see that none of them is lost. */
export const waitingMarks = ({ waitingPlaces }: EditorModel): readonly SVGTemplateResult[] =>
  waitingPlaces.map(([x, y]) => svg`<circle class="early" cx=${x} cy=${y} r="4.5"/>`);
