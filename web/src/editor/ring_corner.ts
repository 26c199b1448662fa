import { type RingCorner, ringCornerAt } from '../document/lasso_corners';
import { draftOf } from '../tools/machine';
import { isLassoing } from './hit_areas';
import { type EditorState, projectOf } from './state';

/** The focused corner of the selection's outline: keys are about it while the lasso draws nothing. */
export function ringCornerInHand(state: EditorState): RingCorner | null {
  const { on, ring } = state.focus;
  const shown = on === 'ring' && ring && isLassoing(state) && !draftOf(state.tools);
  return shown && ringCornerAt(projectOf(state), ring) ? ring : null;
}
