/** Undo steps: edits, undo and redo, and changes by the page. */

import { type ModeReturn, modeOf } from '../../document/bending';
import { type KeyRef, newKeys } from '../../document/clip_keys';
import { type Document, fileProject, handleById, isSameWork } from '../../document/document';
import { putHandles } from '../../document/edits';
import * as history from '../../document/history';
import type { Handle, PoseMode } from '../../document/project';
import { withoutStaleShape } from '../../document/shape';
import { say, type Wording } from '../../texts/wording';
import { cancelPress, forgetTakenCorners, isPressing, restoreDrawing } from '../../tools/machine';
import type { Emit } from '../effects';
import { openClip } from '../open_clip';
import { documentOf, type EditorState, selectionOf } from '../state';
import type { Work } from '../work';
import { withTimeline } from './clip_slice';
import { guardEnded, landed, shapeKept, withDocument, withHistory } from './document_slice';
import { edited } from './edited';
import { announce } from './notices';
import { ownPose } from './playback';
import { closeTimeline, returnToMoment } from './playhead';
import { applyTools, endPress, endPressKeepingChanges } from './press';
import { select } from './selection';

/** Opens work: a document with its history and its unfinished drawing. The drawing brings its tool. */
export function openWork(
  state: EditorState,
  { record, drawings = [], saved }: Work,
  emit: Emit,
): EditorState {
  const { readonly, posable } = state.page;
  const drawing = readonly || posable ? null : drawings[0];
  const rested = closeTimeline(endPress(state, restoreDrawing(state.tools, drawing), emit), emit);
  const opened = withDocument(guardEnded(rested), {
    drawn: null,
    travelled: null,
    automaticDepths: new Map(),
    history: history.historyOf(record),
    saved: saved ?? (record.past[0]?.value ?? record.present).project,
  });
  return edited(opened, 'open', emit);
}

/**
 * Selects handles for the page. That ends a press, whose changes stay.
 *
 * The same handles once more end nothing: pages that bind the selection both ways set it back during each press.
 */
export function selectForPage(state: EditorState, ids: readonly string[], emit: Emit): EditorState {
  if (ids.join('\n') === selectionOf(state).join('\n')) return state;
  if (!isPressing(state.tools)) return select(state, ids, emit);
  const ended = endPressKeepingChanges(state, emit);
  const changed = ended.document.history.past !== state.document.history.past;
  return select(changed ? edited(ended, 'change', emit) : ended, ids, emit);
}

/** Commits a change and announces it, unless it changes nothing. Consecutive ones with the same key form one step. */
export function step(
  state: EditorState,
  label: Wording,
  document: Document,
  emit: Emit,
  key: string | null = null,
): EditorState {
  const next = commitStep(guardEnded(state), label, document, emit, key);
  return next.document.history === state.document.history ? next : announce(next, label);
}

/**
 * Commits a change unless it changes nothing. Consecutive changes with the same key form one undo step: they move
 * handles little by little, as a drag does.
 */
export function commitStep(
  state: EditorState,
  label: Wording,
  document: Document,
  emit: Emit,
  key: string | null = null,
): EditorState {
  const before = documentOf(state);
  const landing = landed(state, before, document);
  const changed = key === null ? withoutStaleShape(before, landing) : shapeKept(state, landing);
  const next = history.step(state.document.history, label, changed, isSameWork, key);
  if (next === state.document.history) return state;
  const stepped = withDocument(ownPose(state, emit), { history: next, travelled: null });
  // The current press would overwrite this step. Its changes so far are a step of their own.
  return edited(applyTools(stepped, cancelPress(stepped.tools), emit), 'change', emit);
}

/** Poses handles without a step. A press continues, and keeps control of its handles. */
export function poseForPage(state: EditorState, handles: readonly Handle[], emit: Emit): EditorState {
  const held = state.tools.current.holds ? selectionOf(state) : [];
  const posed = handles.filter(({ id }) => !held.includes(id));
  if (posed.length === 0) return state;
  const ids = new Set([...state.document.posedByPage, ...posed.map(({ id }) => id)]);
  const amended = history.amend(state.document.history, (document) =>
    withoutStaleShape(document, putHandles(document, posed)),
  );
  return edited(withDocument(state, { history: amended, posedByPage: [...ids] }), 'pose', emit);
}

export const undo = (state: EditorState, emit: Emit): EditorState => travel(state, 'undo', emit);
export const redo = (state: EditorState, emit: Emit): EditorState => travel(state, 'redo', emit);

function travel(before: EditorState, way: 'undo' | 'redo', emit: Emit): EditorState {
  const cancelled = applyTools(before, cancelPress(before.tools), emit);
  const state = guardEnded({ ...cancelled, tools: forgetTakenCorners(cancelled.tools) });
  const { history: present } = state.document;
  const [label, move] =
    way === 'undo' ? [history.undoLabel(present), history.undo] : [history.redoLabel(present), history.redo];
  if (label === null) return state;
  const moved = returnToMoment(withDocument(state, { history: move(present), travelled: way }));
  const travelled = withTimeline(moved, { selected: keysOfStep(label, state, moved) });
  const { handle } = state.focus;
  // The focused handle may have been renamed: keys continue at the selected one.
  if (handle !== null && !handleById(documentOf(travelled), handle))
    emit({ type: 'focus', target: { handle: selectionOf(travelled)[0] ?? null, corner: null } });
  return announce(
    edited(travelled, 'change', emit),
    say(way === 'undo' ? 'spoken.undone' : 'spoken.redone', label),
  );
}

/** Steps about selected keys. */
const OF_KEYS: readonly string[] = ['moveKeys', 'pasteKeys', 'mirrorKeys', 'deleteKeys'].map(
  (name) => `steps.${name}`,
);

/**
 * The keys that are selected after undo or redo: those that a step about keys brings, as the document selects the
 * handles of others. Another step leaves them as long as it selects no other handles.
 */
function keysOfStep({ key }: Wording, before: EditorState, after: EditorState): readonly KeyRef[] {
  const [old, clip] = [openClip(before), openClip(after)];
  if (!old || !clip) return [];
  if (OF_KEYS.includes(key) || key.startsWith('steps.ease.')) return newKeys(clip, old);
  return String(selectionOf(before)) === String(selectionOf(after)) ? before.timeline.selected : [];
}

/** The last project in a mode other than the present one, and the project after it; null if there is none. */
export function modeReturn(state: EditorState, mode: PoseMode): ModeReturn | null {
  const { values, at } = history.timeline(state.document.history);
  const projects = values.slice(0, at + 1).map(fileProject);
  const last = projects.findLastIndex((project) => modeOf(project) === mode);
  const [before, after] = [projects[last], projects[last + 1]];
  return before && after ? { before, after } : null;
}

/** Keeps the next nudge from merging into the last step. */
export const endMerging = (state: EditorState): EditorState =>
  withHistory(state, history.endMerging(state.document.history));
