/** Presses of the tools: their effects on the document, the display and the view. */

import { handleById, isSameWork } from '../../document/document';
import { putHandles } from '../../document/edits';
import type { PosedDocument } from '../../document/group';
import * as history from '../../document/history';
import { revertHandle } from '../../document/reverting';
import { panned } from '../../geometry/camera';
import { say, type Wording } from '../../texts/wording';
import { cancelPress, type ToolsOutcome } from '../../tools/machine';
import type { Effect } from '../../tools/state';
import { beginCrossing, crossed, withDepths, withNeededDepths } from '../crossing';
import type { Emit } from '../effects';
import { beginGuarding, guarded } from '../fold_guard';
import { draftWords } from '../selection_words';
import { documentOf, type EditorState } from '../state';
import { moveCamera } from '../view';
import { saveWork } from './autosave';
import { noteStroke } from './brush_use';
import { committed, guardEnded, noteDepths, withDocument, withHistory } from './document_slice';
import { edited } from './edited';
import { look } from './lens';
import { announce, announceAt, closeStepNotice, informOfStep } from './notices';
import { letGo, ownPose } from './playback';
import { beginRecording, dropRecording, endRecording, recordMove } from './recording';
import { select } from './selection';

/** Takes the outcome of a tool and reduces its effects. */
export const applyTools = (state: EditorState, { tools, effects }: ToolsOutcome, emit: Emit): EditorState =>
  effects.reduce((next, effect) => reduced(next, effect, emit), { ...state, tools });

function reduced(state: EditorState, effect: Effect, emit: Emit): EditorState {
  switch (effect.type) {
    case 'begin':
      return beginRecording(beginDrag(noteStroke(closeStepNotice(state, emit)), effect.label), emit);
    case 'edit':
      return drag(state, effect, emit);
    case 'commit':
      return endDrag(state, emit);
    case 'bail':
      return bailDrag(state, emit);
    case 'select':
      return select(state, effect.ids, emit);
    case 'drawn':
      return withDocument(state, { drawn: effect });
    case 'drafted':
      return saveWork(announce(state, draftWords(effect.draft)), emit);
    case 'box':
      return { ...state, display: { ...state.display, box: effect.box } };
    case 'guides':
      return { ...state, display: { ...state.display, guides: effect.guides } };
    case 'pan':
      return moveCamera(state, panned(state.view.camera, effect.by));
    case 'look':
      // The tool may have been chosen before there was a picture.
      if (state.study.page !== 'lens')
        emit({ type: 'follow-up', event: { type: 'study-shown', page: 'lens' } });
      return look(state, effect.at);
    case 'miss':
      emit({ type: 'follow-up', event: { type: 'placement-missed', at: effect.at } });
      return state;
    case 'ring-focus':
      emit({ type: 'focus', target: { handle: null, corner: null, ring: effect.corner } });
      return state;
    case 'left-out':
      return informOfStep(state, say('notices.leftOut', effect.count), emit);
    case 'lassoed':
      emit({ type: 'follow-up', event: { type: 'lasso-drawn', ring: effect.ring, hole: effect.hole } });
      return state;
  }
}

/** Ends the current press and keeps its changes so far. */
export function endPressKeepingChanges(state: EditorState, emit: Emit): EditorState {
  return committed(guardEnded(endPress(state, cancelPress(state.tools), emit)));
}

/** Drops the effects that end a press, except the one that clears its selection box. */
export const endPress = (state: EditorState, { tools, effects }: ToolsOutcome, emit: Emit): EditorState =>
  applyTools(state, { tools, effects: effects.filter(({ type }) => type === 'box') }, emit);

/** Opens an undo step for a drag. */
function beginDrag(state: EditorState, label: Wording): EditorState {
  const deformation = state.solution.shown?.deformation ?? null;
  const begun = withDocument(state, {
    history: history.begin(state.document.history, label, isSameWork),
    travelled: null,
    refused: [],
    posedByPage: [],
    crossing: beginCrossing(deformation, documentOf(state)),
  });
  return { ...begun, guard: beginGuarding(state.guard, documentOf(state), deformation) };
}

/** Carries out one move of a drag. */
function drag(state: EditorState, edit: PosedDocument, emit: Emit): EditorState {
  const present = documentOf(state);
  // A drag computes each move from the document at its start, which still has the refused handles, and the poses of
  // that moment.
  const led = state.document.posedByPage.flatMap((id) => handleById(present, id) ?? []);
  const wanted = state.document.refused.reduce(
    (mended, handle) => revertHandle(mended, handle, present),
    putHandles(withDepths(edit.document, state.document.crossing), led),
  );
  const deformation = state.solution.shown?.deformation ?? null;
  const { document, guard } = guarded(state.guard, deformation, present, { ...edit, document: wanted });
  const before = state.document.history.open?.value ?? present;
  const crossing = crossed(state.document.crossing, deformation, before, document);
  const raised = crossing === state.document.crossing ? document : withDepths(document, crossing);
  const next = withDocument(state, { crossing, history: history.update(state.document.history, raised) });
  return edited(recordMove({ ...next, guard }), 'input', emit);
}

/** Ends a drag: one undo step, or none if it changed nothing. */
function endDrag(before: EditorState, emit: Emit): EditorState {
  if (before.playback.playing) return edited(letGo(guardEnded(before)), 'input', emit);
  const state = endRecording(guardEnded(noteDepths(loweredAgain(before), before.document.crossing)), emit);
  const ended = committed(state);
  // A drag that changed nothing: its label must disappear from undo.
  if (ended.document.history.past === state.document.history.past) return edited(ended, 'input', emit);
  const next = edited(ownPose(ended, emit), 'drag', emit);
  const label = history.undoLabel(next.document.history);
  return label ? announceAt(next, label) : next;
}

/** Drops the depths that a drag has decided, where it ends without a crossing. */
function loweredAgain(state: EditorState): EditorState {
  const { history: steps, crossing } = state.document;
  const leader = state.solution.shown?.deformation ?? null;
  const before = steps.open?.value;
  if (!before) return state;
  const document = withNeededDepths(steps.present, crossing, leader, before);
  return document === steps.present ? state : withHistory(state, history.update(steps, document));
}

/** Takes a drag back. */
const bailDrag = (state: EditorState, emit: Emit): EditorState =>
  edited(
    dropRecording(guardEnded(withHistory(state, history.bail(state.document.history))), emit),
    'input',
    emit,
  );
