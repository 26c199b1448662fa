/** Notices, texts for screen readers, and the progress of tasks. */

import { solveKey } from '../../document/solved';
import { asError, isAbort, isEngineFailure } from '../../error';
import { isSameWording, say, type Wording, type Words } from '../../texts/wording';
import type { Emit } from '../effects';
import { errorWords } from '../error_words';
import { turnsOf } from '../hit_areas';
import type { Notice, NoticeAction, NoticesState } from '../notice';
import { mayChange } from '../permissions';
import { placeWords } from '../selection_words';
import { documentOf, type EditorState, projectOf } from '../state';
import type { Task, TaskName } from '../task';
import type { Handlers } from './handlers';

/** Long enough to read a sentence twice. */
const PASSING_MS = 6000;
/** Long enough to decide as well. */
const ANSWER_MS = 15_000;

const withNotices = (state: EditorState, change: Partial<NoticesState>): EditorState => ({
  ...state,
  notices: { ...state.notices, ...change },
});

/** The notice on screen. A page that plays shows only errors. */
export const shownNotice = ({ page, notices }: EditorState): Notice | null =>
  page.posable
    ? (notices.error ?? notices.graphics)
    : (notices.passing ?? notices.error ?? notices.graphics ?? notices.offer);

/** The newest task under way. */
export const currentTask = ({ notices }: EditorState): Task | null => notices.tasks.at(-1) ?? null;

/** Shows a notice. Its action dismisses it. Notices without an action disappear automatically, except errors. */
export function notify(state: EditorState, given: Notice, emit: Emit): EditorState {
  const notice = joined(state.notices.passing, given);
  const cleared = withoutPassing(state, emit);
  const { kind, action, passes = !action } = notice;
  // An older error would hide the offer.
  if (!passes) return withNotices(cleared, { offer: notice, error: null });
  if (kind === 'error') return withNotices(cleared, { error: notice });
  startPassing(notice, emit);
  return withNotices(cleared, { passing: notice });
}

/** Joins notices about the same step. */
function joined(before: Notice | null, notice: Notice): Notice {
  if (!before?.ofStep || !notice.ofStep) return notice;
  const said = sentencesOf(before.text);
  if (said.some((sentence) => isSameWording(sentence, notice.text))) return before;
  return { ...before, ...notice, text: say('names.sentences', [...said, notice.text]) };
}

/** The sentences of joined notices. */
const sentencesOf = (text: Words): readonly Words[] =>
  typeof text !== 'string' && text.key === 'names.sentences' ? (text.values[0] as readonly Words[]) : [text];

export const inform = (state: EditorState, text: Words, emit: Emit): EditorState =>
  notify(state, { kind: 'info', text }, emit);

/** Informs about the last step, until the next one. */
export const informOfStep = (state: EditorState, text: Wording, emit: Emit): EditorState =>
  notify(state, { kind: 'info', text, ofStep: true }, emit);

/**
 * Shows an error with the editor's text, and passes it to the page unchanged. A failure of the solver itself can be
 * retried. Ignores AbortErrors: superseded work is no error.
 *
 * @param reverted the step that caused the error was taken back.
 * @param action for an error that is not of the solver itself.
 */
export function report(
  state: EditorState,
  thrown: unknown,
  emit: Emit,
  reverted = false,
  action: NoticeAction | null = null,
): EditorState {
  const error = asError(thrown);
  if (isAbort(error)) return state;
  const isUnsolved = state.solution.shown?.key !== solveKey(projectOf(state));
  const answer =
    isEngineFailure(error) && isUnsolved
      ? ({ label: say('answers.tryAgain'), event: { type: 'retry-asked' } } as const)
      : action;
  const notice = { kind: 'error', text: errorWords(error, reverted) } as const;
  const next = notify(state, answer ? { ...notice, action: answer, passes: true } : notice, emit);
  emit({ type: 'notify-page', notification: { type: 'error', error } });
  return next;
}

/** Announces words. Screen readers read only changes, so words that are repeated are marked. */
export function announce(state: EditorState, words: Wording): EditorState {
  const { announcement: last } = state.notices;
  const again = last !== null && !last.again && isSameWording(last.words, words);
  return withNotices(state, { announcement: { words, again } });
}

/** Announces a step, and where it has led the selected handles. */
export function announceAt(state: EditorState, step: Wording): EditorState {
  const place = placeWords(documentOf(state), turnsOf(state));
  return announce(state, place ? say('spoken.stepAt', step, place) : step);
}

/** Another step was done, undone or redone: closes the notice about the step before. */
export const closeStepNotice = (state: EditorState, emit: Emit): EditorState =>
  state.notices.passing?.ofStep ? withoutPassing(state, emit) : state;

/** The solver works: closes the error that can be retried. */
export const closeRetryNotice = (state: EditorState): EditorState =>
  state.notices.error?.action?.event.type === 'retry-asked' ? withNotices(state, { error: null }) : state;

export const clearNotices = (state: EditorState, emit: Emit): EditorState =>
  withNotices(withoutPassing(state, emit), { error: null, offer: null });

/** Closes the shown notice. */
export function dismiss(state: EditorState, emit: Emit): EditorState {
  const notice = shownNotice(state);
  if (notice === state.notices.passing) return withoutPassing(state, emit);
  if (notice === state.notices.graphics) return withoutGraphicsNotice(state);
  return withNotices(state, notice === state.notices.error ? { error: null } : { offer: null });
}

/** Shows that nothing can be drawn. Other pictures do not close this notice: they are not drawn either. */
export const notifyOfGraphics = (state: EditorState, text: Wording): EditorState =>
  withNotices(state, { graphics: { kind: 'error', text } });

export const withoutGraphicsNotice = (state: EditorState): EditorState =>
  state.notices.graphics ? withNotices(state, { graphics: null }) : state;

/** Shows a task, replacing one of the same name. */
export const beginTask = (state: EditorState, task: Task, emit: Emit): EditorState =>
  withTasks(state, [...state.notices.tasks.filter(({ name }) => name !== task.name), task], emit);

/** Shows how much of a task is done, and how long it will still take. */
export const followTask = (
  state: EditorState,
  name: TaskName,
  progress: Pick<Task, 'fraction' | 'left'>,
  emit: Emit,
): EditorState =>
  withTasks(
    state,
    state.notices.tasks.map((task) => (task.name === name ? { ...task, ...progress } : task)),
    emit,
  );

export const endTask = (state: EditorState, name: TaskName, emit: Emit): EditorState =>
  state.notices.tasks.some((task) => task.name === name)
    ? withTasks(
        state,
        state.notices.tasks.filter((task) => task.name !== name),
        emit,
      )
    : state;

function withTasks(state: EditorState, tasks: readonly Task[], emit: Emit): EditorState {
  const next = withNotices(state, { tasks });
  const [before, after] = [currentTask(state), currentTask(next)];
  if (before !== after) {
    const { label, fraction = null } = after ?? { label: null };
    emit({ type: 'notify-page', notification: { type: 'progress', label, fraction } });
  }
  return next;
}

function withoutPassing(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'stop-timer', timer: 'notice' });
  return state.notices.passing ? withNotices(state, { passing: null }) : state;
}

const startPassing = ({ action }: Notice, emit: Emit): void =>
  emit({ type: 'start-timer', timer: 'notice', ms: action ? ANSWER_MS : PASSING_MS });

/** Keeps a notice that disappears automatically, or restarts its time. */
export function keepPassing({ notices }: EditorState, keep: boolean, emit: Emit): void {
  if (keep) emit({ type: 'stop-timer', timer: 'notice' });
  else if (notices.passing) startPassing(notices.passing, emit);
}

export const noticeHandlers: Handlers<
  | 'notice-dismissed'
  | 'notice-answered'
  | 'notice-hovered'
  | 'person-informed'
  | 'error-reported'
  | 'number-refused'
> = {
  'notice-dismissed': (state, _, emit) => dismiss(state, emit),
  'notice-answered': (state, { other }, emit) => {
    const notice = shownNotice(state);
    const { kind } = notice ?? {};
    const action = other ? notice?.other : notice?.action;
    if (!action || (kind === 'info' && !action.readsOnly && !mayChange(state))) return state;
    emit({ type: 'follow-up', event: action.event });
    return dismiss(state, emit);
  },
  'notice-hovered': (state, { on }, emit) => {
    keepPassing(state, on, emit);
    return state;
  },
  'person-informed': (state, { text }, emit) => inform(state, text, emit),
  'number-refused': (state, { text }, emit) => inform(state, text, emit),
  'error-reported': (state, { error }, emit) => report(state, error, emit),
};
