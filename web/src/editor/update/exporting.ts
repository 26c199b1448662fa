import type { Project } from '../../document/project';
import type { Emit } from '../effects';
import { EXPORT_FORMATS, type ExportChoices } from '../export_choices';
import { EXPORT_CANCELLED, savedText } from '../notice_texts';
import { stem } from '../picture';
import { type EditorState, type ExportState, filedProject, projectOf } from '../state';
import { reachesBeyondFrame } from '../view';
import { saveWork } from './autosave';
import type { Handlers } from './handlers';
import { announce, beginTask, endTask, followTask, inform, notify, report } from './notices';

/** Steps of the percentage that screen readers announce. */
const ANNOUNCED = 0.25;

const withExport = (state: EditorState, change: Partial<ExportState>): EditorState => ({
  ...state,
  exporting: { ...state.exporting, ...change },
});

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

export function exportPicture(
  state: EditorState,
  emit: Emit,
  { instead = {}, holdsPicture = false }: ExportOptions = {},
): EditorState {
  const { picture, exporting } = state;
  if (!picture || exporting.running) return state;
  const choices = { ...exporting.choices, ...instead };
  const { extension } = EXPORT_FORMATS[choices.format];
  const name = `${stem(picture.name)}-warped${choices.area === 'grown' ? '-all' : ''}.${extension}`;
  const cut = choices.area === 'picture' && reachesBeyondFrame(state);
  const carried = { project: projectForFile(state), picture: holdsPicture ? picture : null };
  emit({ type: 'export', name, project: projectOf(state), choices, carried });
  const task = { name: 'export', label: 'Exporting', cancellable: true, fraction: 0 } as const;
  return beginTask(withExport(state, { running: { cut } }), task, emit);
}

export function cancelExport(state: EditorState, emit: Emit): EditorState {
  if (state.exporting.running) emit({ type: 'cancel-export' });
  return state;
}

/** Shows whole percents only, and announces a few of them. */
function follow(state: EditorState, fraction: number, emit: Emit): EditorState {
  const before = state.notices.tasks.find(({ name }) => name === 'export')?.fraction ?? 0;
  const now = Math.floor(fraction * 100) / 100;
  if (!state.exporting.running || now <= before) return state;
  const next = followTask(state, 'export', now, emit);
  const isStep = Math.floor(now / ANNOUNCED) > Math.floor(before / ANNOUNCED) && now < 1;
  return isStep ? announce(next, `Exporting, ${Math.round(now * 100)} percent`) : next;
}

function ended(before: EditorState, saved: string | null, error: Error | null, emit: Emit): EditorState {
  const cut = before.exporting.running?.cut ?? false;
  const state = withExport(endTask(before, 'export', emit), { running: null });
  if (error) return report(state, error, emit);
  if (saved === null) return announce(state, EXPORT_CANCELLED);
  const text = savedText(saved, cut);
  if (!cut) return inform(state, text, emit);
  const event = { type: 'command-run', command: 'export-all' } as const;
  const action = { label: 'Export all', readsOnly: true, event } as const;
  return notify(state, { kind: 'info', text, action, passes: true }, emit);
}

export const exportHandlers: Handlers<'export-ended' | 'export-progressed' | 'export-choice-made'> = {
  'export-progressed': (state, { fraction }, emit) => follow(state, fraction, emit),
  'export-ended': (state, { saved, error }, emit) => ended(state, saved, error, emit),
  'export-choice-made': (state, { choice }, emit) =>
    saveWork(withExport(state, { choices: { ...state.exporting.choices, ...choice } }), emit),
};
