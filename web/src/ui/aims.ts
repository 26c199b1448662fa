/** Aims over the picture: the box of a drag, the crosshair of the keyboard, and presses that wait for their picture. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';

/** The box of a drag over empty space, in stage pixels. */
export function selectionBox({ box, camera }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!box) return nothing;
  const [x, y] = toStage(camera, box.min);
  const [right, bottom] = toStage(camera, box.max);
  return svg`<rect class="box" x=${x} y=${y} width=${right - x} height=${bottom - y}/>`;
}

/** Half the size of a finger from the middle to each end, CSS pixels. The dot in the middle has no length. */
const CROSS = 'M-22 0H-6M6 0H22M0 -22V-6M0 6V22M0 0H0';

/** Where the keyboard would place a handle: as large as a finger, and open in the middle, where the handle will be. */
export function crosshair({ crosshair: at, camera }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!at) return nothing;
  const [x, y] = toStage(camera, at);
  return svg`<g class="crosshair" transform="translate(${x} ${y})">
    <path class="under" d=${CROSS}/><path d=${CROSS}/>
  </g>`;
}

/** The waiting presses: people see that none of them is lost. */
export const waitingMarks = ({ waitingPlaces }: EditorModel): readonly SVGTemplateResult[] =>
  waitingPlaces.map(([x, y]) => svg`<circle class="early" cx=${x} cy=${y} r="4.5"/>`);
