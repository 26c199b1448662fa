/** Consequences of every change of the document: a solve, saving, the page's events, checks, and what closes. */

import { selectedHandles } from '../../document/document';
import { corners } from '../../document/handle';
import { redoLabel, undoLabel } from '../../document/history';
import { isSameWording, type Wording } from '../../texts/wording';
import { draftOf } from '../../tools/machine';
import type { Emit, PageNotification } from '../effects';
import { isLassoing } from '../hit_areas';
import { documentOf, type EditorState, filedProject, selectionOf } from '../state';
import { contain } from '../view';
import { saveWork } from './autosave';
import { showSelected } from './display';
import { withDocument } from './document_slice';
import { closeMenuUnlessSelected } from './menu_closing';
import { closeStepNotice } from './notices';
import { schedulePoseCheck } from './pose_checks';
import { requestSolution } from './solve_request';

/**
 * `open`: another document; `input`: during a drag; `drag`: its end, a step; `change`: any other step; `selection`:
 * only the selection changed; `pose`: the page has posed handles, without a step.
 */
export type ChangeKind = 'open' | 'input' | 'drag' | 'change' | 'selection' | 'pose';

/** Nudges merge into one undo step unless the pause between them is longer. */
const MERGE_MS = 800;

export function edited(before: EditorState, kind: ChangeKind, emit: Emit): EditorState {
  // Before the solution of this step, which may be known and cause a notice. A drag does so as it begins.
  let state = kind === 'change' ? closeStepNotice(before, emit) : before;
  if (solves(state, kind)) state = requestSolution(state, emit);
  state = withFocusedCornerSelected(closeMenuUnlessSelected(state, emit));
  if (selectionOf(state) !== state.document.reported.selection) emit({ type: 'scroll-list' });
  if (kind === 'selection') state = selected(state, emit);
  else {
    state = schedulePoseCheck(state, emit);
    if (kind !== 'pose' && undoLabel(state.document.history) !== null)
      state = withDocument(state, { touched: true });
  }
  if (isStep(kind)) {
    emit({ type: 'start-timer', timer: 'merge-end', ms: MERGE_MS });
    // Keeps the selected handles within view, so that they can be moved back.
    if (state.page.posable)
      state = contain(
        state,
        selectedHandles(documentOf(state)).flatMap((handle) => corners(handle)),
      );
  }
  if (kind !== 'input' && kind !== 'pose') state = saveWork(state, emit);
  return notifyPage(state, kind, emit);
}

const isStep = (kind: ChangeKind): boolean => kind === 'change' || kind === 'drag';

/** A solver that has failed is asked again at the end of a drag, not at each of its moves. */
const solves = ({ solution }: EditorState, kind: ChangeKind): boolean =>
  kind === 'input' ? !solution.failed : kind !== 'selection' && kind !== 'pose';

function selected(state: EditorState, emit: Emit): EditorState {
  // The lasso hides the handles. During a drawing, keyboard commands apply to its corners.
  if ((isLassoing(state) || draftOf(state.tools)) && selectionOf(state).length > 0) {
    emit({ type: 'follow-up', event: { type: 'tool-set', tool: 'select' } });
  }
  return showSelected(state);
}

function withFocusedCornerSelected(state: EditorState): EditorState {
  const { corner } = state.focus;
  if (!corner || selectionOf(state).includes(corner.id)) return state;
  return { ...state, focus: { ...state.focus, corner: null } };
}

const isSameLabel = (a: Wording | null, b: Wording | null): boolean =>
  a === b || (a !== null && b !== null && isSameWording(a, b));

/** Emits the DOM events of a change. */
function notifyPage(state: EditorState, kind: ChangeKind, emit: Emit): EditorState {
  const { reported, history } = state.document;
  const selection = selectionOf(state);
  const now = { selection, undo: undoLabel(history), redo: redoLabel(history) };
  const notify = (notification: PageNotification) => emit({ type: 'notify-page', notification });
  if (selection.join('\n') !== reported.selection.join('\n')) notify({ type: 'selectionchange', selection });
  if (isStep(kind)) notify({ type: 'change', project: filedProject(state) });
  else if (kind === 'input') notify({ type: 'input', project: filedProject(state) });
  if (!isSameLabel(now.undo, reported.undo) || !isSameLabel(now.redo, reported.redo)) {
    notify({ type: 'historychange', undo: now.undo, redo: now.redo });
  }
  return withDocument(state, { reported: { ...reported, ...now } });
}
