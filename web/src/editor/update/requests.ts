/** Requests to open something: by files, by the page, by the attributes, and by earlier work. */

import type { ProjectFile } from '../../document/project';
import { say } from '../../texts/wording';
import { addressIn, nameIn, namesProject } from '../address';
import type { Emit, ProjectSource } from '../effects';
import { noAddressWords } from '../notice_words';
import type { OpeningState, ProjectRead, Purpose, Restoring } from '../opening_state';
import type { NamedFile } from '../picture';
import type { EditorState } from '../state';
import type { WorkSnapshot } from '../work';
import { snapshotOf } from './autosave';
import type { Handlers } from './handlers';
import { announce, notify } from './notices';
import { requestSolution } from './solve_request';

export const withOpening = (state: EditorState, change: Partial<OpeningState>): EditorState => ({
  ...state,
  opening: { ...state.opening, ...change },
});

interface Read {
  readonly pictures: readonly (string | NamedFile)[];
  readonly project?: ProjectSource | null;
  readonly work?: WorkSnapshot;
}

/** Gives up the picture being read. */
export function abandonReading(state: EditorState, emit: Emit): EditorState {
  const { reading } = state.opening;
  if (!reading) return state;
  emit({ type: 'abandon-read', id: reading.id });
  emit({ type: 'follow-up', event: { type: 'request-ended', request: reading, outcome: 'superseded' } });
  return withOpening(state, { reading: null });
}

/** Reads a picture instead of the one being read. */
export function requestPicture(before: EditorState, purpose: Purpose, read: Read, emit: Emit): EditorState {
  const state = abandonReading(before, emit);
  const { nextId: id } = state.opening;
  const inside = purpose.by === 'person';
  emit({ type: 'read', id, pictures: read.pictures, project: read.project ?? null, inside });
  const [first] = read.pictures;
  const name = typeof first === 'string' ? nameIn(first) : (first?.name ?? '');
  const request = { id, name, purpose, work: read.work ?? null };
  // Input for a picture that a person no longer wants.
  const waiting = purpose.by === 'person' || purpose.by === 'back' ? [] : state.waiting;
  return withOpening({ ...state, waiting }, { reading: request, nextId: id + 1, overtaken: true });
}

/** Reads the files that the attributes name, with the project that the page set before, if any. */
export function requestAttributes(state: EditorState, src: string, emit: Emit): EditorState {
  const { pageProject, revision, overtaken } = state.opening;
  const { projectSource } = state.page;
  const project = pageProject ? { object: pageProject } : projectSource ? { address: projectSource } : null;
  const requested = requestPicture(state, { by: 'attributes', revision }, { pictures: [src], project }, emit);
  return state.opening.startup.phase === 'done' ? requested : withOpening(requested, { overtaken });
}

/** Brings earlier work back. */
export function restore(
  state: EditorState,
  work: WorkSnapshot,
  from: Restoring['from'],
  emit: Emit,
): EditorState {
  const id = state.opening.nextId;
  emit({ type: 'read', id, pictures: [{ name: work.name, file: work.file }], project: null, inside: false });
  const restoring: Restoring = { id, work, from, phase: 'reading' };
  const guard = { ...state.guard, on: work.guarded, holding: false };
  const { choices, film, engine, kind } = state.exporting;
  const { exports = choices, films = film, engines = engine, maps = state.exporting.maps } = work;
  const chosen = { choices: exports, film: films, engine: engines, maps, kind: work.exportKind ?? kind };
  const exporting = { ...state.exporting, ...chosen };
  const { snapping = state.display.snapping, edgeSnapping = null } = work;
  const display = { ...state.display, snapping, edgeSnapping };
  return withOpening({ ...state, guard, display, exporting }, { restoring, nextId: id + 1 });
}

const isProject = ({ name, file }: NamedFile): boolean =>
  /\.json$/i.test(name) || file.type === 'application/json';

/** The files to be tried as a picture. If nothing may be one, the first says in its refusal why. */
function pictureCandidates(files: readonly NamedFile[]): readonly NamedFile[] {
  // Files of unknown types, such as hidden ones, may be pictures too.
  const possible = files.filter(({ file, folder }) => !folder && /^(image\/.*)?$/.test(file.type));
  const candidates = possible.length > 0 ? possible : files.slice(0, 1);
  return candidates.map((candidate) => ({ ...candidate, name: candidate.name || 'pasted.png' }));
}

function receiveFiles(state: EditorState, files: readonly NamedFile[], emit: Emit): EditorState {
  const project = files.find((file) => isProject(file) && (!file.folder || files.length === 1));
  const received = files.filter((file) => file !== project);
  const pictures = pictureCandidates(received.filter((file) => !isProject(file)));
  if (pictures.length > 0) {
    const source = project ? { named: project } : null;
    return requestPicture(state, { by: 'person', received }, { pictures, project: source }, emit);
  }
  if (!project) return state;
  return readProject(state, { name: project.name, received }, { named: project }, emit);
}

/** Reads only a project. That does not supersede a picture that is being opened. */
function readProject(
  state: EditorState,
  read: Omit<ProjectRead, 'id'>,
  project: ProjectSource,
  emit: Emit,
): EditorState {
  const { nextId: id, readingProjects } = state.opening;
  emit({ type: 'read', id, pictures: [], project, inside: false });
  return withOpening(state, { nextId: id + 1, readingProjects: [...readingProjects, { id, ...read }] });
}

function openAddress(state: EditorState, text: string, emit: Emit): EditorState {
  const address = addressIn(text);
  if (!address) return notify(state, { kind: 'error', text: noAddressWords(text) }, emit);
  if (namesProject(address))
    return readProject(state, { name: nameIn(address), received: [] }, { address }, emit);
  return requestPicture(state, { by: 'person', received: [] }, { pictures: [address] }, emit);
}

/** Cancels reading for a person or a page. What was open before stays. */
export function cancelReading(before: EditorState, emit: Emit): EditorState {
  const state = abandonReading(before, emit);
  for (const { id } of state.opening.readingProjects) emit({ type: 'abandon-read', id });
  return announce(withOpening(state, { readingProjects: [] }), say('spoken.cancelled'));
}

const projectSource = (project: string | ProjectFile | null): ProjectSource | null =>
  project === null ? null : typeof project === 'string' ? { address: project } : { object: project };

/** Reopens after a failure of the solver: the shown project, the open picture with its work, or the attributes. */
function retry(state: EditorState, emit: Emit): EditorState {
  if (state.solution.shown) return requestSolution(state, emit);
  const work = snapshotOf(state);
  if (work) {
    return requestPicture(
      state,
      { by: 'retry' },
      { pictures: [{ name: work.name, file: work.file }], work },
      emit,
    );
  }
  const { src } = state.page;
  return src ? requestAttributes(state, src, emit) : state;
}

export const requestHandlers: Handlers<
  | 'files-received'
  | 'address-given'
  | 'sample-chosen'
  | 'offered'
  | 'load-asked'
  | 'source-changed'
  | 'source-asked'
  | 'back-asked'
  | 'picture-asked'
  | 'retry-asked'
> = {
  'files-received': (state, { files }, emit) => receiveFiles(state, files, emit),
  'address-given': (state, { text }, emit) => openAddress(state, text, emit),
  'sample-chosen': (state, { sample: { src, project } }, emit) => {
    const source = project === undefined ? null : { address: project };
    return requestPicture(state, { by: 'person', received: [] }, { pictures: [src], project: source }, emit);
  },
  offered: (state, { names, opening }, emit) => {
    if (state.picture) {
      const action = { label: say('answers.open'), event: opening } as const;
      return notify(state, { kind: 'info', text: say('notices.offered', names), action }, emit);
    }
    emit({ type: 'follow-up', event: opening });
    return state;
  },
  'load-asked': (state, { reply, source, project, notice }, emit) => {
    const { pageProject } = state.opening;
    const purpose = { by: 'load', reply, usesPageProject: project ? null : pageProject, notice } as const;
    return requestPicture(
      state,
      purpose,
      { pictures: [source], project: projectSource(project ?? pageProject) },
      emit,
    );
  },
  'source-changed': (state) => withOpening(state, { revision: state.opening.revision + 1 }),
  'source-asked': (state, _, emit) => {
    const { src } = state.page;
    return src ? requestAttributes(state, src, emit) : state;
  },
  'back-asked': (state, { work }, emit) =>
    requestPicture(
      state,
      { by: 'back', work },
      { pictures: [{ name: work.name, file: work.file }], work },
      emit,
    ),
  'picture-asked': (state, _, emit) => {
    emit({ type: 'pick-file' });
    return state;
  },
  'retry-asked': (state, _, emit) => retry(state, emit),
};
