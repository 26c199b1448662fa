/** Converts places in the window to places on the stage. Both are in CSS pixels, but a page may scale the editor. */
import type { Vec } from '../geometry/vec';

export function clientToStage(stage: Element, [x, y]: Vec): Vec {
  const { left, top, width, height } = stage.getBoundingClientRect();
  const { clientWidth, clientHeight } = stage;
  return [((x - left) * clientWidth) / (width || 1), ((y - top) * clientHeight) / (height || 1)];
}

export function stageToClient(stage: Element, [x, y]: Vec): Vec {
  const { left, top, width, height } = stage.getBoundingClientRect();
  const { clientWidth, clientHeight } = stage;
  return [left + (x * width) / (clientWidth || 1), top + (y * height) / (clientHeight || 1)];
}
