/** Rings that pulse where the posed picture is turned over. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';
import type { Crease } from '../geometry/crease';
import { distance, midpoint } from '../geometry/vec';

/** More rings than these would hide the picture. */
const MOST_RINGS = 8;
/** Radii of rings, CSS pixels: the space around a crease, and the most. */
const RADII = { apart: 18, most: 90 };

/** A drag moves creases faster than a ring pulses, so the rings wait for its end. */
export const creaseMarks = ({
  creases,
  camera,
  pressing,
}: EditorModel): SVGTemplateResult | typeof nothing =>
  pressing
    ? nothing
    : svg`${repeat(
        creases.slice(0, MOST_RINGS),
        // A crease that changes is a new ring, and pulses again.
        ({ box, area }) => `${box.min} ${area}`,
        ({ box }) => ring(box, camera),
      )}`;

function ring(box: Crease['box'], camera: EditorModel['camera']): SVGTemplateResult {
  const [x, y] = toStage(camera, midpoint(box.min, box.max));
  const radius = Math.min(RADII.most, RADII.apart + (distance(box.min, box.max) * camera.scale) / 2);
  return svg`<g class="crease-place" transform="translate(${x} ${y})"><circle r=${radius}/></g>`;
}
