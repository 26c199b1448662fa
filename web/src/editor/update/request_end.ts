/** Ends requests: notifies the requester, and continues with the initial content. */

import { codeOf, isAbort, isEngineFailure } from '../../error';
import { say } from '../../texts/wording';
import type { Emit, Origin } from '../effects';
import { notOpenedWords } from '../notice_words';
import type { OpenOutcome, OpenRequest, Purpose, Restoring } from '../opening_state';
import { attributesPending } from '../opening_state';
import type { NamedFile } from '../picture';
import { bounded } from '../recent';
import { documentOf, type EditorState } from '../state';
import { isWorkedOn } from '../work';
import { saveWork, stepKey, withAutosave } from './autosave';
import { withDocument } from './document_slice';
import type { Handlers } from './handlers';
import { inform, report } from './notices';
import { requestAttributes, restore, withOpening } from './requests';
import { chooseByHandles } from './tool_choice';

/** A picture is open. A picture that the user did not choose may play automatically. */
function notifyLoad(origin: Origin, emit: Emit): void {
  emit({ type: 'notify-page', notification: { type: 'load', origin } });
  if (origin !== 'person') emit({ type: 'follow-up', event: { type: 'autoplay-asked' } });
}

function endRequest(
  state: EditorState,
  { id, purpose }: OpenRequest,
  outcome: OpenOutcome,
  emit: Emit,
): EditorState {
  switch (purpose.by) {
    case 'person':
      if (outcome === 'opened') notifyLoad('person', emit);
      return outcome === 'opened'
        ? filesOpened(withLoss(state, emit), purpose.received, emit)
        : failed(state, outcome, emit);
    case 'back':
      if (outcome === 'opened') notifyLoad('person', emit);
      return outcome === 'opened' ? filesOpened(state, [], emit) : failed(state, outcome, emit);
    case 'load':
      return endLoad(state, purpose, outcome, emit);
    case 'retry':
      if (outcome === 'opened') notifyLoad('page', emit);
      return failed(state, outcome, emit);
    case 'attributes': {
      if (outcome === 'opened') notifyLoad('page', emit);
      const ended = failed(withOpening(state, { openedRevision: purpose.revision }), outcome, emit);
      const isNewest = purpose.revision === state.opening.revision;
      if (outcome !== 'opened' && isNewest) emit({ type: 'source-failed', error: outcome });
      const { startup, overtaken } = ended.opening;
      if (startup.phase !== 'attributes' || startup.id !== id) return ended;
      const back = outcome instanceof Error && !overtaken ? startup.orElse : null;
      return back ? reopen(ended, back, emit) : finishStartup(ended, startup.unread, emit);
    }
  }
}

/** Reports an error of a request. */
const failed = (state: EditorState, outcome: OpenOutcome, emit: Emit): EditorState =>
  outcome instanceof Error ? report(state, outcome, emit) : state;

function endLoad(
  before: EditorState,
  { reply, usesPageProject, notice }: Extract<Purpose, { by: 'load' }>,
  outcome: OpenOutcome,
  emit: Emit,
): EditorState {
  if (outcome === 'opened') {
    notifyLoad('page', emit);
    emit({ type: 'settle-load', reply, error: null });
    return before;
  }
  emit({ type: 'settle-load', reply, error: outcome });
  const state = notice ? failed(before, outcome, emit) : before;
  const { pageProject } = state.opening;
  const blamed = usesPageProject !== null && usesPageProject === pageProject && isOfProject(outcome);
  return blamed ? withOpening(state, { pageProject: null }) : state;
}

/** Whether an error is about the project, not about its picture, the solver, or a newer request. */
const isOfProject = (outcome: OpenOutcome): boolean =>
  outcome instanceof Error &&
  !isAbort(outcome) &&
  !isEngineFailure(outcome) &&
  !['address', 'file', 'picture'].includes(codeOf(outcome));

/** Says that a file with several frames is opened as its first, or a drawing without its texts. */
function withLoss(state: EditorState, emit: Emit): EditorState {
  const { picture } = state;
  if (picture?.moves) return inform(state, say('notices.moves', picture.name), emit);
  return picture?.lacksTexts ? inform(state, say('notices.lacksTexts', picture.name), emit) : state;
}

/** Names ignored files. */
const filesOpened = (state: EditorState, ignored: readonly NamedFile[], emit: Emit): EditorState =>
  ignored.length > 0 ? inform(state, notOpenedWords(ignored.map(({ name }) => name)), emit) : state;

/** Drops the input for a picture that is refused, unless a newer one is being opened. */
function withoutInput(state: EditorState, outcome: OpenOutcome): EditorState {
  const { reading, trial } = state.opening;
  return outcome instanceof Error && !reading && !trial ? { ...state, waiting: [] } : state;
}

function endRestore(
  before: EditorState,
  { work, from }: Restoring,
  outcome: OpenOutcome,
  emit: Emit,
): EditorState {
  let state = before;
  if (from === 'refusal') return outcome instanceof Error ? park(state, work) : state;
  if (from === 'storage') state = withAutosave(state, { restoring: false });
  if (outcome === 'opened') {
    if (from === 'storage') {
      state = withDocument(state, { touched: work.record.past.length > 0 });
      // The solver refused the last stored step: store the work without it.
      if (documentOf(state) !== work.record.present) state = saveWork(state, emit);
    }
    notifyLoad('restored', emit);
    return finishStartup(state, null, emit);
  }
  // Without a solver nothing can be opened.
  const unread =
    from === 'storage' && outcome instanceof Error && !isEngineFailure(outcome) && !isAbort(outcome);
  if (unread) {
    // Work that the solver breaks at is parked, and its picture is open without handles: the next visit opens that.
    const kept = withAutosave(state, { unread: state.picture === null });
    return startAttributes(park(kept, work), null, outcome, emit);
  }
  return finishStartup(failed(state, outcome, emit), null, emit);
}

const park = (state: EditorState, work: Restoring['work']): EditorState =>
  withOpening(state, { recent: bounded([...state.opening.recent, work]) });

function startAttributes(
  state: EditorState,
  orElse: Restoring['work'] | null,
  unread: Error | null,
  emit: Emit,
): EditorState {
  const { src } = state.page;
  if (!src || state.opening.overtaken) return finishStartup(state, unread, emit);
  const startup = { phase: 'attributes', id: state.opening.nextId, orElse, unread } as const;
  return requestAttributes(withOpening(state, { startup }), src, emit);
}

const reopen = (state: EditorState, work: Restoring['work'], emit: Emit): EditorState =>
  restore(withOpening(state, { startup: { phase: 'restoring' } }), work, 'element', emit);

function finishStartup(state: EditorState, unread: Error | null, emit: Emit): EditorState {
  if (state.opening.startup.phase === 'done') return state;
  const next = withOpening(state, { startup: { phase: 'done' } });
  const reported = unread ? report(next, unread, emit) : next;
  emit({ type: 'notify-page', notification: { type: 'ready' } });
  return reported;
}

export const requestEndHandlers: Handlers<
  'started' | 'storage-read' | 'request-ended' | 'restore-ended' | 'files-opened'
> = {
  started: (state, { work }, emit) => {
    if (attributesPending(state.opening)) return startAttributes(state, work, null, emit);
    if (work) return reopen(state, work, emit);
    if (state.autosave.key === null) return startAttributes(state, null, null, emit);
    emit({ type: 'read-storage' });
    return withOpening(state, { startup: { phase: 'storage' } });
  },
  'storage-read': (state, { stored }, emit) => {
    if (state.opening.startup.phase !== 'storage') return state;
    if (!stored) return startAttributes(state, null, null, emit);
    const { work, recent } = stored;
    const known = withAutosave(withOpening(state, { recent }), { step: stepKey(work) });
    // Another picture was opened meanwhile: the work waits beside it.
    if (state.opening.overtaken)
      return finishStartup(isWorkedOn(work) ? park(known, work) : known, null, emit);
    const restoring = withAutosave(withOpening(known, { startup: { phase: 'restoring' } }), {
      restoring: true,
    });
    return restore(restoring, work, 'storage', emit);
  },
  'request-ended': (state, { request, outcome }, emit) =>
    endRequest(withoutInput(state, outcome), request, outcome, emit),
  'restore-ended': (state, { restoring, outcome }, emit) =>
    endRestore(withoutInput(state, outcome), restoring, outcome, emit),
  'files-opened': (state, { ignored }, emit) => chooseByHandles(filesOpened(state, ignored, emit), emit),
};
