/** The cursor over the stage: it announces what a press would do. */
import { selectedHandles } from '../document/document';
import { groupTurn } from '../document/group';
import { draftOf, isPressing } from '../tools/machine';
import { ringHit } from '../tools/ring_hit';
import { gripsOf, hitAt, isLassoing } from './hit_areas';
import { handlesAreShown, pressesPan } from './permissions';
import { documentOf, type EditorState, projectOf } from './state';

/** A CSS cursor, or `turn`, for which CSS has none. */
export type Cursor =
  | 'default'
  | 'grab'
  | 'grabbing'
  | 'pointer'
  | 'crosshair'
  | 'move'
  | 'turn'
  | `${(typeof SCALE_DIRECTIONS)[number]}-resize`;

/** The direction of the scaling grip, by eighths of a turn of the ring. */
const SCALE_DIRECTIONS = ['nwse', 'ns', 'nesw', 'ew'] as const;

export function cursorOf(state: EditorState): Cursor {
  const { tools, pointer } = state;
  if (!state.picture) return 'default';
  const pressing = isPressing(tools);
  if (pressesPan(state) || tools.tool === 'hand') return pressing ? 'grabbing' : 'grab';
  if (tools.tool === 'lens' || tools.tool === 'brush') return 'crosshair';
  const draft = draftOf(tools);
  if (draft) return draft.finishing ? 'pointer' : 'crosshair';
  if (pointer.hovered && isLassoing(state) && !pressing && !pointer.alt)
    if (ringHit(projectOf(state), gripsOf(state), pointer.hovered)) return 'move';
  const places = tools.tool !== 'select';
  const under =
    pointer.hovered && handlesAreShown(state)
      ? hitAt(state, pointer.hovered, !places, undefined, pointer.alt)
      : null;
  if (under?.part === 'ring' || (under && pointer.alt && under.part !== 'grip')) return 'turn';
  if (under?.part === 'grip') return scaleCursor(state);
  if (under) return pressing ? 'grabbing' : 'move';
  return places ? 'crosshair' : 'default';
}

function scaleCursor(state: EditorState): Cursor {
  const turn = groupTurn(selectedHandles(documentOf(state)));
  return `${SCALE_DIRECTIONS[Math.round(turn / 45) & 3] ?? 'nwse'}-resize`;
}
