/**
 * Converts places in the window to places on the stage. Both are in CSS pixels, but a page may scale, turn, mirror or
 * tilt the editor. A bounding rectangle does not contain that, so zero-size marks are placed in the corners of the
 * stage.
 */
import { html, type TemplateResult } from 'lit-html';
import { inverted, mapped, type Quad, squareToQuad } from '../geometry/homography';
import type { Vec } from '../geometry/vec';

/** The marks, clockwise from the top left. */
export const cornerMarks = (): TemplateResult => html`<i class="corner-mark"></i><i class="corner-mark"></i
  ><i class="corner-mark"></i><i class="corner-mark"></i>`;

export function clientToStage(stage: Element, client: Vec): Vec {
  const onto = squareToQuad(cornersOf(stage));
  const back = onto && inverted(onto);
  const [width, height] = sizeOf(stage);
  const [x, y] = back ? mapped(back, client) : [0, 0];
  return [x * width, y * height];
}

export function stageToClient(stage: Element, [x, y]: Vec): Vec {
  const corners = cornersOf(stage);
  const onto = squareToQuad(corners);
  const [width, height] = sizeOf(stage);
  return onto ? mapped(onto, [x / width, y / height]) : corners[0];
}

const cornersOf = (stage: Element): Quad =>
  Array.from(stage.querySelectorAll('.corner-mark'), (mark): Vec => {
    const { x, y } = mark.getBoundingClientRect();
    return [x, y];
  }) as unknown as Quad;

/** Unlike `clientWidth`, in fractions of pixels. */
function sizeOf(stage: Element): Vec {
  const { width, height } = getComputedStyle(stage);
  return [Number.parseFloat(width) || 1, Number.parseFloat(height) || 1];
}
