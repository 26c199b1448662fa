/** The picture held by keys: Enter takes hold of it with the pushing brush, arrows push it, and Enter lets go. */
import { isPressing, pressUp } from '../../tools/machine';
import { pressAt } from '../../tools/state';
import type { Emit } from '../effects';
import { contextWithoutHandles, isBrushing } from '../hit_areas';
import type { EditorState } from '../state';
import { applyTools } from './press';

export const isHeldByKeys = (state: EditorState): boolean =>
  isBrushing(state) && isPressing(state.tools) && state.display.crosshair !== null;

/** Lets go of what keys hold: the stroke so far is a step. */
export function releaseByKeys(state: EditorState, emit: Emit): EditorState {
  const { crosshair } = state.display;
  if (!isHeldByKeys(state) || !crosshair) return state;
  return applyTools(state, pressUp(state.tools, pressAt(crosshair), contextWithoutHandles(state)), emit);
}
