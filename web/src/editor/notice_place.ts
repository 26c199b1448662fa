/** The place of notices on the stage: at their usual edge, or at the opposite one if they would cover a handle. */
import { corners } from '../document/handle';
import { type Camera, type Size, toStage } from '../geometry/camera';
import { PHONE } from './sizes';
import { type EditorState, projectOf } from './state';
import { insets } from './view';

/** The most room that a notice takes, with a hint below it and half of a handle, CSS pixels. */
const AT_TOP = 90;
const AT_BOTTOM = 140;
const HALF_WIDTH = 290;

/** Whether a notice is shown at the opposite edge. Phones show it at the top, other screens at the bottom. */
export function noticeIsAside(state: EditorState): boolean {
  const { stage, view } = state;
  const [atTop, atBottom] = coveredEdges(state, stage, view.camera);
  const [usual, opposite] = stage.width < PHONE ? [atTop, atBottom] : [atBottom, atTop];
  return usual && !opposite;
}

/** Whether handles lie where a notice at the top, and one at the bottom, would be. */
function coveredEdges(state: EditorState, stage: Size, camera: Camera): readonly [boolean, boolean] {
  const { left, right } = insets(state);
  const middle = (left + stage.width - right) / 2;
  const inReach = projectOf(state)
    .handles.flatMap((handle) => corners(handle))
    .map((at) => toStage(camera, at))
    .filter(([x, y]) => Math.abs(x - middle) < HALF_WIDTH && y > 0 && y < stage.height);
  return [inReach.some(([, y]) => y < AT_TOP), inReach.some(([, y]) => y > stage.height - AT_BOTTOM)];
}
