/** The brush: its size, its strength, whether it erases, and the mask as a whole. */
import { withoutStiffness } from '../../document/stiffness';
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
  const size = sizeBeside(state.brush.size, way);
  return announce(withBrush(state, { size }), `Brush size ${size} percent`);
}

export function switchErasing(state: EditorState): EditorState {
  const erases = !state.brush.erases;
  return announce(withBrush(state, { erases }), erases ? 'The brush erases' : 'The brush paints');
}

/** Makes the whole picture soft, but for polygons. */
function clearStiffness(state: EditorState, emit: Emit): EditorState {
  const project = withoutStiffness(projectOf(state));
  return step(state, 'Clear stiffness', { ...documentOf(state), project }, emit);
}

export const brushHandlers: Handlers<'brush-set' | 'stiffness-cleared'> = {
  'brush-set': (state, { change }) => withBrush(state, change),
  'stiffness-cleared': (state, _, emit) => (mayEdit(state) ? clearStiffness(state, emit) : state),
};
