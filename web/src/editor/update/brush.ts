/** The brush: its effect, its size and strength, and the way back from all that it has done. */

import { withoutDisplacement } from '../../document/displacement';
import { withoutStiffness } from '../../document/stiffness';
import { say } from '../../texts/wording';
import { oppositeBrush } from '../../tools/brush_kinds';
import { type BrushState, sizeBeside } from '../brush_state';
import type { Emit } from '../effects';
import { mayEdit } from '../permissions';
import { documentOf, type EditorState, projectOf } from '../state';
import type { Handlers } from './handlers';
import { announce } from './notices';
import { step } from './steps';

const withBrush = (state: EditorState, change: Partial<BrushState>): EditorState => ({
  ...state,
  brush: { ...state.brush, ...change },
});

export function resizeBrush(state: EditorState, way: 1 | -1): EditorState {
  const size = sizeBeside(state.brush, way);
  return announce(withBrush(state, { size }), say('spoken.brushSize', size));
}

/** Switches to the effect of Alt. */
export function switchBrush(state: EditorState): EditorState {
  const brush = oppositeBrush(state.brush);
  const { kind, erases } = brush;
  const effect = kind !== 'stiffen' ? kind : erases ? 'erases' : 'paints';
  return announce({ ...state, brush }, say(`spoken.brush.${effect}`));
}

/** Makes the whole picture soft, but for polygons. */
function clearStiffness(state: EditorState, emit: Emit): EditorState {
  const project = withoutStiffness(projectOf(state));
  return step(state, say('steps.clearStiffness'), { ...documentOf(state), project }, emit);
}

/** Takes back all that the brush has moved. */
function clearDisplacement(state: EditorState, emit: Emit): EditorState {
  const project = withoutDisplacement(projectOf(state));
  return step(state, say('steps.clearStrokes'), { ...documentOf(state), project }, emit);
}

export const brushHandlers: Handlers<'brush-set' | 'stiffness-cleared' | 'displacement-cleared'> = {
  'brush-set': (state, { change }) => withBrush(state, change),
  'stiffness-cleared': (state, _, emit) => (mayEdit(state) ? clearStiffness(state, emit) : state),
  'displacement-cleared': (state, _, emit) => (mayEdit(state) ? clearDisplacement(state, emit) : state),
};
