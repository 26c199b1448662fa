/** Trials: a picture on the stage until its first solution, with the way back to the picture before it. */

import { openDocument } from '../../document/document';
import type { Project } from '../../document/project';
import { say } from '../../texts/wording';
import { offers } from '../can_run';
import type { Emit } from '../effects';
import { errorWords, ofFreshPicture } from '../error_words';
import type { EventOf } from '../events';
import type { NoticeAction } from '../notice';
import { awaitingWords } from '../notice_words';
import type { OpeningState, OpenRequest, ProjectRead, Purpose, Trial } from '../opening_state';
import { belongs, fits, misfit, type Picture, type SourceFile } from '../picture';
import { otherVersion, withReplaced } from '../recent';
import { type EditorState, projectOf } from '../state';
import type { Work, WorkSnapshot } from '../work';
import { saveOpened, snapshotOf, workOf } from './autosave';
import { withDocument } from './document_slice';
import type { Handlers } from './handlers';
import { inform, notify } from './notices';
import { endPressKeepingChanges } from './press';
import { closePicture, freshWork, putPicture } from './put_picture';
import { abandonReading, restore, withOpening } from './requests';
import { rigOfProject, rigOfWork } from './rig';
import { select } from './selection';
import { step } from './steps';
import { choose, chooseByHandles } from './tool_choice';

/** What was read. */
type Opened = Pick<EventOf<'read-ended'>, 'source' | 'project' | 'carried'> & { readonly picture: Picture };

/** Starts the trial of a picture that was read for the newest request. */
function tryRequested(
  before: EditorState,
  { picture, source, project: given, carried }: Opened,
  emit: Emit,
): EditorState {
  const { reading, awaiting } = before.opening;
  if (!reading) return before;
  const request = withoutOpened(reading, source);
  // A drag in hand is part of the work that gives way.
  let state = withOpening(endPressKeepingChanges(before, emit), { reading: null });
  // A picture of the page is never one that a person was asked to choose.
  const isAwaited = awaiting && request.purpose.by === 'person' && belongs(picture, awaiting.project);
  const awaited = isAwaited ? awaiting.project : null;
  const asked = request.work ? null : (given ?? awaited);
  const error = asked && misfit(picture, asked);
  // A person may use the project's rig on this picture, or open its own.
  const isTakable = error && request.purpose.by === 'person' && asked.handles.length > 0;
  const waiting = isTakable ? asked : null;
  const project = waiting ? null : asked;
  if (waiting)
    state = withOpening(state, { awaiting: { name: say('notices.theProject'), project: waiting } });
  else if (error) {
    emit({ type: 'follow-up', event: { type: 'request-ended', request, outcome: error } });
    return state;
  }
  if (project && project === awaited) state = withOpening(state, { awaiting: null });
  const present = project && { project, selection: [] };
  const work = request.work ?? (present && { record: { past: [], present, future: [] } });
  const recent = recentAfter(state, request.purpose.by === 'back' ? request.work : null, request.purpose.by);
  const withProject = given !== null && !waiting;
  const trial = { request, withProject, carried, fresh: work === null, recent };
  const tried = startTrial(state, trial, picture, work ?? freshWork(picture, state.page), emit);
  // Not once it is solved: by then the person may have chosen another tool.
  return isOfPerson(request.purpose) ? chooseByHandles(tried, emit) : tried;
}

/** The recent work once a picture of this purpose is open: the edited picture that it replaces is not lost. */
function recentAfter(state: EditorState, back: WorkSnapshot | null, by: string): readonly WorkSnapshot[] {
  const { recent, restoring } = state.opening;
  if (by !== 'person' && by !== 'back') return recent;
  const others = recent.filter(({ id }) => id !== back?.id);
  return withReplaced(others, restoring?.work ?? snapshotOf(state));
}

/** Of a person's files, those that do not open. */
function withoutOpened(request: OpenRequest, source: SourceFile | null): OpenRequest {
  const { purpose } = request;
  if (purpose.by !== 'person') return request;
  return {
    ...request,
    purpose: { ...purpose, received: purpose.received.filter(({ file }) => file !== source) },
  };
}

const isOfPerson = ({ by }: Purpose): boolean => by === 'person' || by === 'back';

function startTrial(
  before: EditorState,
  trial: Omit<Trial, 'before' | 'opened'>,
  picture: Picture,
  work: Work,
  emit: Emit,
): EditorState {
  const superseded = before.opening.trial;
  let state = superseded ? superseding(before, superseded, emit) : before;
  if (trial.request) state = suspendRestoring(state, emit);
  // A picture that is opened once more because it could not be solved is no way back from itself.
  const again = state.picture?.file === picture.file && !state.solution.shown;
  const last = again ? null : state.picture;
  const way =
    last && !superseded
      ? { picture: last, work: workOf(state), tool: state.tools.tool }
      : (superseded?.before ?? null);
  const begun = { ...trial, opened: work.record.present, before: way };
  return putPicture(withOpening(state, { trial: begun }), picture, work, emit);
}

function superseding(state: EditorState, { request }: Trial, emit: Emit): EditorState {
  if (!request) return suspendRestoring(state, emit);
  emit({ type: 'follow-up', event: { type: 'request-ended', request, outcome: 'superseded' } });
  return state;
}

/** A newer picture goes first. The work that is being restored comes back if that picture is refused. */
function suspendRestoring(state: EditorState, emit: Emit): EditorState {
  const { restoring } = state.opening;
  if (!restoring || restoring.phase === 'suspended') return state;
  if (restoring.phase === 'reading') emit({ type: 'abandon-read', id: restoring.id });
  emit({ type: 'follow-up', event: { type: 'restore-ended', restoring, outcome: 'superseded' } });
  return withOpening(state, { restoring: { ...restoring, phase: 'suspended' } });
}

/** A project in the picture waits for the picture that it is for. */
function awaitingAfter({ picture, opening }: EditorState, { carried }: Trial): OpeningState['awaiting'] {
  if (!picture || !carried || carried instanceof Error) return opening.awaiting;
  return { name: picture.name, project: carried };
}

/** Ends the trial of a picture that is solved. */
export function endTrialOpened(before: EditorState, trial: Trial, emit: Emit): EditorState {
  const { restoring } = before.opening;
  // A person who brings another project together with its picture no longer waits.
  const waits = !(trial.withProject && trial.request?.purpose.by === 'person');
  const awaiting = waits ? awaitingAfter(before, trial) : null;
  let state = withOpening(before, { trial: null, restoring: null, recent: trial.recent, awaiting });
  const isBrought = trial.fresh && trial.request?.purpose.by === 'person';
  const rig = isBrought && trial.before ? rigOfWork(trial.before.picture, trial.before.work) : null;
  state = offerNext(saveOpened(applyPageSettings(state, trial.withProject, emit), emit), emit, rig);
  if (trial.carried instanceof Error && state.picture) {
    state = inform(state, say('notices.notCarried', state.picture.name, errorWords(trial.carried)), emit);
  }
  if (offers(state, 'export')) emit({ type: 'prepare-export' });
  if (trial.request) {
    emit({ type: 'follow-up', event: { type: 'request-ended', request: trial.request, outcome: 'opened' } });
  } else if (restoring) {
    emit({ type: 'follow-up', event: { type: 'restore-ended', restoring, outcome: 'opened' } });
  }
  return state;
}

/**
 * Ends the trial of a picture that cannot be solved: the previous picture comes back.
 *
 * @param error why, or `superseded` if the page gave it up.
 * @param refused the solver refuses the project. Without a previous picture, the picture stays without its handles.
 */
export function endTrialRejected(
  before: EditorState,
  trial: Trial,
  error: Error | 'superseded',
  refused: boolean,
  emit: Emit,
): EditorState {
  const { picture } = before;
  const { restoring } = before.opening;
  let state = withOpening(before, { trial: null });
  if (trial.before) {
    const { picture, work, tool } = trial.before;
    state = choose(putPicture(state, picture, work, emit), tool, emit);
  } else if (refused && picture && projectOf(state).handles.length > 0) {
    state = putPicture(state, picture, freshWork(picture, state.page), emit);
  } else if (refused) state = closePicture(state, emit);
  state = offerNext(state, emit);
  if (!trial.request) {
    state = withOpening(state, { restoring: null });
    if (restoring) emit({ type: 'follow-up', event: { type: 'restore-ended', restoring, outcome: error } });
    return state;
  }
  if (restoring) state = restore(state, restoring.work, 'refusal', emit);
  const inWords = error !== 'superseded' && trial.fresh && refused && picture;
  const outcome = inWords ? ofFreshPicture(error, picture.name) : error;
  emit({ type: 'follow-up', event: { type: 'request-ended', request: trial.request, outcome } });
  return state;
}

/** Applies the project and the selection that the page set before there was a picture. */
function applyPageSettings(state: EditorState, withProject: boolean, emit: Emit): EditorState {
  const { pageProject, pageSelection } = state.opening;
  const next = withOpening(state, { pageProject: null, pageSelection: null });
  if (pageProject && !withProject)
    emit({ type: 'adopt-page-project', project: pageProject, selection: pageSelection });
  else if (pageSelection) return select(next, pageSelection, emit);
  return next;
}

/**
 * Asks for the picture of a waiting project, or offers the other version of a work, or the way back.
 *
 * @param rig offers the rig of the picture before.
 */
function offerNext(state: EditorState, emit: Emit, rig: NoticeAction | null = null): EditorState {
  const { picture, opening, page } = state;
  if (opening.awaiting) return askForPicture(state, emit);
  if (!picture) return state;
  const version = otherVersion(opening.recent, picture);
  if (version) {
    const action = {
      label: say('answers.showOtherVersion'),
      event: { type: 'back-asked', work: version },
    } as const;
    const other = { label: say('answers.keepThis'), event: { type: 'version-kept' } } as const;
    return notify(
      state,
      { kind: 'info', text: say('notices.twoVersions', picture.name), action, other },
      emit,
    );
  }
  const last = opening.recent.at(-1);
  if (page.posable || !(last || rig)) return state;
  const back: NoticeAction | null = last
    ? { label: say('answers.backTo', last.name), event: { type: 'back-asked', work: last } }
    : null;
  const [action, other] = rig ? [rig, back] : [back, null];
  const text = say('notices.isOpen', picture.name);
  const actions = { ...(action && { action }), ...(other && { other }) };
  return notify(state, { kind: 'info', text, ...actions, ofStep: true, passes: true }, emit);
}

/** Asks for the picture of the waiting project. An open picture can take its rig. */
function askForPicture(state: EditorState, emit: Emit): EditorState {
  const { awaiting } = state.opening;
  if (!awaiting) return state;
  const rig = state.picture ? rigOfProject(awaiting.name, awaiting.project) : null;
  const text = awaitingWords(awaiting.name, awaiting.project.image, rig && (state.picture?.name ?? null));
  const action = { label: say('answers.openPicture'), event: { type: 'picture-asked' } } as const;
  return notify(state, { kind: 'info', text, action, ...(rig && { other: rig }) }, emit);
}

/** Applies a project file without a picture to the open picture if the size fits. Otherwise requests its picture. */
function openProject(state: EditorState, name: string, project: Project, emit: Emit): EditorState {
  if (state.picture && fits(state.picture, project)) {
    const next = withDocument(withOpening(state, { awaiting: null }), { saved: project });
    return step(next, say('steps.open', name), openDocument(project), emit);
  }
  return askForPicture(withOpening(state, { awaiting: { name, project } }), emit);
}

/** Opens a project file that holds its picture, instead of the picture being read. */
function tryProjectWithPicture(
  before: EditorState,
  read: ProjectRead,
  opened: Opened,
  emit: Emit,
): EditorState {
  const state = abandonReading(before, emit);
  const request = {
    id: read.id,
    name: read.name,
    purpose: { by: 'person', received: read.received },
    work: null,
  } as const;
  return tryRequested(withOpening(state, { reading: request, overtaken: true }), opened, emit);
}

/** Cancels the picture that the page requested with this reply. The picture before stays open. */
function cancelLoad(state: EditorState, reply: number, emit: Emit): EditorState {
  const isOf = (request: OpenRequest | null | undefined): boolean =>
    request?.purpose.by === 'load' && request.purpose.reply === reply;
  const { reading, trial } = state.opening;
  if (isOf(reading)) return abandonReading(state, emit);
  if (!trial || !isOf(trial.request)) return state;
  const empty = trial.before ? state : closePicture(state, emit);
  return { ...endTrialRejected(empty, trial, 'superseded', false, emit), waiting: [] };
}

export const trialHandlers: Handlers<'read-ended' | 'read-failed' | 'load-cancelled'> = {
  'load-cancelled': (state, { reply }, emit) => cancelLoad(state, reply, emit),
  'read-ended': (state, { id, picture, source, project, carried }, emit) => {
    const { reading, restoring, readingProjects } = state.opening;
    if (picture && reading?.id === id)
      return tryRequested(state, { picture, source, project, carried }, emit);
    if (picture && restoring?.id === id && restoring.phase === 'reading') {
      const solving = withOpening(state, { restoring: { ...restoring, phase: 'solving' } });
      const trial = {
        request: null,
        withProject: false,
        carried: null,
        fresh: false,
        recent: state.opening.recent,
      };
      return startTrial(solving, trial, picture, restoring.work, emit);
    }
    const read = readingProjects.find((other) => other.id === id);
    if (!read || !project) return state;
    const rest = withOpening(state, { readingProjects: readingProjects.filter((other) => other !== read) });
    if (picture) return tryProjectWithPicture(rest, read, { picture, source, project, carried }, emit);
    emit({ type: 'follow-up', event: { type: 'files-opened', ignored: read.received } });
    return openProject(rest, read.name, project, emit);
  },
  'read-failed': (state, { id, error }, emit) => {
    const { reading, restoring, readingProjects } = state.opening;
    if (reading?.id === id) {
      emit({ type: 'follow-up', event: { type: 'request-ended', request: reading, outcome: error } });
      return withOpening(state, { reading: null });
    }
    if (restoring?.id === id && restoring.phase === 'reading') {
      emit({ type: 'follow-up', event: { type: 'restore-ended', restoring, outcome: error } });
      return withOpening(state, { restoring: null });
    }
    if (!readingProjects.some((other) => other.id === id)) return state;
    emit({ type: 'follow-up', event: { type: 'error-reported', error } });
    return withOpening(state, { readingProjects: readingProjects.filter((other) => other.id !== id) });
  },
};
