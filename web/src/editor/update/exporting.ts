import type { Project } from '../../document/project';
import { isSameWording, say, type Words } from '../../texts/wording';
import type { Emit } from '../effects';
import { lossWords } from '../engine_words';
import type { EventOf } from '../events';
import { choicesFor, EXPORT_FORMATS, type ExportChoices } from '../export_choices';
import { timeLeft } from '../film_words';
import { savedWords } from '../notice_words';
import { isDrawing, stem } from '../picture';
import { type EditorState, filedProject } from '../state';
import { reachesBeyondFrame } from '../view';
import { saveWork } from './autosave';
import { drawn } from './drawn';
import { exportEngineRig, lossOf } from './engines';
import { beginExport, withExport } from './export_slice';
import { exportFilm } from './filming';
import type { Handlers } from './handlers';
import { exportMap } from './maps';
import { announce, endTask, followTask, inform, notify, report } from './notices';
import { exportRig } from './web_page';

/** Steps of the percentage that screen readers announce. */
const ANNOUNCED = 0.25;

/** The project with the name of the open picture, for a file. */
export function projectForFile(state: EditorState): Project {
  const project = filedProject(state);
  return { ...project, image: { ...project.image, src: state.picture?.name ?? project.image.src } };
}

interface ExportOptions {
  /** In place of some of the person's choices. */
  readonly instead?: Partial<ExportChoices>;
  /** A PNG carries the original picture too. */
  readonly holdsPicture?: boolean;
}

/** Exports by the last choices. */
export function exportChosen(state: EditorState, emit: Emit): EditorState {
  switch (state.exporting.kind) {
    case 'picture':
      return exportPicture(state, emit);
    case 'film':
      return exportFilm(state, emit);
    case 'page':
      return exportRig(state, emit);
    case 'engine':
      return exportEngineRig(state, emit);
    case 'maps':
      return exportMap(state, emit);
  }
}

export function exportPicture(
  state: EditorState,
  emit: Emit,
  { instead = {}, holdsPicture = false }: ExportOptions = {},
): EditorState {
  const { picture, exporting } = state;
  if (!picture || exporting.running) return state;
  const choices = choicesFor({ ...exporting.choices, ...instead }, isDrawing(picture));
  const { extension } = EXPORT_FORMATS[choices.format];
  const name = `${stem(picture.name)}-warped${choices.area === 'grown' ? '-all' : ''}.${extension}`;
  const cut = choices.area === 'picture' && reachesBeyondFrame(state);
  const carried = { project: projectForFile(state), picture: holdsPicture ? picture : null };
  emit({ type: 'export', name, picture, ...drawn(state), choices, carried });
  return beginExport(state, emit, cut);
}

export function cancelExport(state: EditorState, emit: Emit): EditorState {
  if (state.exporting.running) emit({ type: 'cancel-export' });
  return state;
}

/** Shows whole percents only, and announces a few of them. */
function follow(state: EditorState, fraction: number, seconds: number | undefined, emit: Emit): EditorState {
  const task = state.notices.tasks.find(({ name }) => name === 'export');
  const before = task?.fraction ?? 0;
  const now = Math.max(before, Math.floor(fraction * 100) / 100);
  const left = seconds === undefined ? undefined : timeLeft(seconds);
  if (!state.exporting.running || (now === before && isSameLeft(left, task?.left))) return state;
  const next = followTask(state, 'export', { fraction: now, ...(left && { left }) }, emit);
  const isStep = Math.floor(now / ANNOUNCED) > Math.floor(before / ANNOUNCED) && now < 1;
  return isStep ? announce(next, say('spoken.exporting', Math.round(now * 100))) : next;
}

const isSameLeft = (a: Words | undefined, b: Words | undefined): boolean =>
  a === b || (a !== undefined && b !== undefined && isSameWording(a, b));

function ended(
  before: EditorState,
  { saved, error, remarks = [] }: EventOf<'export-ended'>,
  emit: Emit,
): EditorState {
  const cut = before.exporting.running?.cut ?? false;
  const state = withExport(endTask(before, 'export', emit), { running: null });
  if (error) return report(state, error, emit);
  if (saved === null) return announce(state, say('spoken.exportCancelled'));
  const loss = lossOf(before);
  const sentences = [savedWords(saved, cut), ...(loss ? [lossWords(loss)] : []), ...remarks];
  const text = sentences.length > 1 ? say('names.sentences', sentences) : savedWords(saved, cut);
  if (!cut) return inform(state, text, emit);
  const event = { type: 'command-run', command: 'export-all' } as const;
  const action = { label: say('answers.exportAll'), readsOnly: true, event } as const;
  return notify(state, { kind: 'info', text, action, passes: true }, emit);
}

export const exportHandlers: Handlers<'export-ended' | 'export-progressed' | 'export-choice-made'> = {
  'export-progressed': (state, { fraction, left }, emit) => follow(state, fraction, left, emit),
  'export-ended': ended,
  'export-choice-made': (state, { choice }, emit) =>
    saveWork(withExport(state, { choices: { ...state.exporting.choices, ...choice } }), emit),
};
