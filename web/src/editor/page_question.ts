/** Questions that the page may answer with no, before a person does something. */
import { timeline } from '../document/history';
import type { Handle, Project } from '../document/project';
import type { EditorEffect } from './effects';
import type { EditorEvent } from './events';
import type { ExportKind } from './export_choices';
import { isOpening } from './opening_state';
import type { NamedFile } from './picture';
import { documentOf, type EditorState, projectOf } from './state';

export type PageQuestion =
  /** Files, or an address that was typed, pasted, dropped or chosen. */
  | { readonly type: 'beforeopen'; readonly files: readonly NamedFile[]; readonly address: string | null }
  /** `picture`: the file holds it too. */
  | {
      readonly type: 'beforesave';
      readonly name: string;
      readonly project: Project;
      readonly picture: NamedFile | null;
    }
  | { readonly type: 'beforeexport'; readonly name: string; readonly kind: ExportKind }
  | { readonly type: 'beforeadd' | 'beforeremove'; readonly handles: readonly Handle[] };

/** Events that change handles by the page, by a solver that refuses them, or by name only. */
const NOT_ASKED: ReadonlySet<EditorEvent['type']> = new Set([
  'handle-added',
  'handle-changed',
  'handle-removed',
  'handles-posed',
  'project-adopted',
  'undo-asked',
  'redo-asked',
  'solve-refused',
  'name-given',
  'renaming-ended',
]);

/** The questions before an event, which leads from one state to another. */
export function questionsOf(
  before: EditorState,
  after: EditorState,
  event: EditorEvent,
): readonly PageQuestion[] {
  switch (event.type) {
    case 'files-received':
      return [{ type: 'beforeopen', files: event.files, address: null }];
    case 'address-given':
      return [{ type: 'beforeopen', files: [], address: event.text }];
    case 'sample-chosen':
      return [{ type: 'beforeopen', files: [], address: event.sample.src }];
    default:
      return NOT_ASKED.has(event.type) ? [] : handleQuestions(before, after);
  }
}

function handleQuestions(before: EditorState, after: EditorState): readonly PageQuestion[] {
  const [had, has] = [projectOf(before).handles, projectOf(after).handles];
  if (had === has || before.picture !== after.picture || isOpening(before.opening)) return [];
  const [added, removed] = [without(has, had), without(had, has)];
  if (added.length === 0 && removed.length === 0) return [];
  // Undo, redo, and the end of a drag that is cancelled, lead to a document that was admitted before.
  if (timeline(before.document.history).values.includes(documentOf(after))) return [];
  const questions: PageQuestion[] = [];
  if (added.length > 0) questions.push({ type: 'beforeadd', handles: added });
  if (removed.length > 0) questions.push({ type: 'beforeremove', handles: removed });
  return questions;
}

const without = (all: readonly Handle[], others: readonly Handle[]): readonly Handle[] => {
  const ids = new Set(others.map(({ id }) => id));
  return all.filter(({ id }) => !ids.has(id));
};

const KINDS = {
  export: 'picture',
  'export-film': 'film',
  'export-rig': 'page',
  'export-engine-rig': 'engine',
  'export-map': 'maps',
} as const satisfies Partial<Record<EditorEffect['type'], ExportKind>>;

/** The question before an effect is carried out; null for none. */
export function questionOf(effect: EditorEffect): PageQuestion | null {
  switch (effect.type) {
    case 'save-project':
      return { type: 'beforesave', name: effect.name, project: effect.project, picture: effect.picture };
    case 'export':
    case 'export-film':
    case 'export-rig':
    case 'export-engine-rig':
    case 'export-map':
      return { type: 'beforeexport', name: effect.name, kind: KINDS[effect.type] };
    default:
      return null;
  }
}
