/** Choosing a tool, by a person or the page. */
import { say } from '../../texts/wording';
import { isDrawable } from '../../tools/drafting';
import { chooseTool, drawingOf, draws, places, restoreDrawing, type ToolName } from '../../tools/machine';
import type { Draft } from '../../tools/state';
import { hideCrosshair } from '../crosshair';
import type { Emit } from '../effects';
import type { NoticeAction } from '../notice';
import { type EditorState, projectOf } from '../state';
import type { Handlers } from './handlers';
import { releaseByKeys } from './held_by_keys';
import { wantLuminance } from './luminance';
import { announce, notify } from './notices';
import { applyTools } from './press';
import { select } from './selection';

export function choose(before: EditorState, tool: ToolName, emit: Emit): EditorState {
  const { posable, readonly } = before.page;
  if (posable || (readonly && tool !== 'hand' && tool !== 'lens')) return before;
  const state = releaseByKeys(before, emit);
  const drawing = tool === state.tools.tool ? null : drawingOf(state.tools);
  let next = applyTools(state, chooseTool(state.tools, tool), emit);
  if (drawing && isDrawable(drawing)) next = tellOfDrawing(next, drawing, emit);
  // Arrow keys move the crosshair of such a tool only while nothing is selected.
  if (draws(tool) || tool === 'brush') {
    next = select(next, [], emit);
    next = { ...next, display: { ...next.display, settings: false } };
  }
  // With a placing tool Enter must reach the stage, not the focused handle.
  if (places(tool) && isOnHandles(next)) focusStage(emit);
  return wantLuminance(hideCrosshair(next), emit);
}

/** Chooses a tool for a person, and announces it. */
export function takeTool(state: EditorState, tool: ToolName, emit: Emit): EditorState {
  const next = choose(state, tool, emit);
  if (next.tools.tool !== tool) return next;
  // Arrows and Enter place with it.
  if (places(tool) || tool === 'lens') focusStage(emit);
  return announce(next, say(`commands.${tool}`));
}

/** Chooses the point tool for an opened picture without handles, and the select tool for one with handles. */
export function chooseByHandles(state: EditorState, emit: Emit): EditorState {
  const { picture, page, tools } = state;
  if (!picture || page.tool || (tools.tool !== 'select' && tools.tool !== 'point')) return state;
  const tool = projectOf(state).handles.length === 0 ? 'point' : 'select';
  const next = tool === tools.tool ? state : takeTool(state, tool, emit);
  return next.tools.tool === tools.tool
    ? state
    : announce(next, say('spoken.toolAndPicture', say(`commands.${tool}`), picture.name));
}

const isOnHandles = ({ focus }: EditorState): boolean => focus.on === 'handle' || focus.on === 'corner';

const focusStage = (emit: Emit): void => emit({ type: 'focus', target: { handle: null, corner: null } });

/** The way back to a drawing that has ended without a result: a dozen clicks may be in it. */
export const continuing = (draft: Draft): NoticeAction => ({
  label: say('answers.continueDrawing'),
  event: { type: 'drawing-continued', draft },
});

export const tellOfDrawing = (state: EditorState, draft: Draft, emit: Emit): EditorState =>
  notify(
    state,
    {
      kind: 'info',
      text: say('notices.drawingEnded'),
      action: continuing(draft),
      passes: true,
    },
    emit,
  );

export const toolHandlers: Handlers<'drawing-continued'> = {
  'drawing-continued': (before, { draft }, emit) => {
    const state = choose(before, draft.kind, emit);
    if (state.tools.tool !== draft.kind) return before;
    focusStage(emit);
    const { tools, effects } = restoreDrawing(state.tools, draft);
    return applyTools(state, { tools, effects: [...effects, { type: 'drafted', draft }] }, emit);
  },
};
