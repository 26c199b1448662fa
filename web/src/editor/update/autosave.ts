/** Autosave: the work is stored under a key after each step, and tabs that share the key are notified. */

import { fileProject } from '../../document/document';
import { recordOf, timeline } from '../../document/history';
import { say } from '../../texts/wording';
import { drawingOf } from '../../tools/machine';
import type { AutosaveState } from '../autosave_state';
import type { Emit } from '../effects';
import type { EditorState } from '../state';
import { isWorkedOn, type Work, type WorkSnapshot } from '../work';
import { withDocument } from './document_slice';
import type { Handlers } from './handlers';
import { inform, notify } from './notices';

const withAutosave = (state: EditorState, change: Partial<AutosaveState>): EditorState => ({
  ...state,
  autosave: { ...state.autosave, ...change },
});

export function workOf({ document, tools, view, pixelated }: EditorState): Work {
  const drawing = drawingOf(tools);
  return {
    record: recordOf(document.history),
    drawings: drawing ? [drawing] : [],
    view,
    pixelated,
    saved: document.saved,
  };
}

/** The open picture and its work; during a trial, the previous ones. */
export function snapshotOf(state: EditorState): WorkSnapshot | null {
  const { picture, opening, guard, display, exporting } = state;
  const open = opening.trial ? opening.trial.before : picture && { picture, work: workOf(state) };
  if (!open) return null;
  const { id, file, name, thumbnail } = open.picture;
  const { kind: exportKind, choices: exports, film: films, engine: engines, maps } = exporting;
  const chosen = { exports, films, engines, maps, exportKind };
  const { snapping, edgeSnapping } = display;
  const settings = {
    guarded: guard.on,
    snapping,
    ...(edgeSnapping !== null && { edgeSnapping }),
    ...chosen,
  };
  return { id, file, name, thumbnail, ...open.work, ...settings };
}

/** Identifies a step or a corner of a drawing. Selecting something is no step. */
export const stepKey = ({ name, record: { past, future }, drawings = [] }: WorkSnapshot): string =>
  [
    name,
    past.length,
    JSON.stringify(past.at(-1)?.label),
    future.length,
    ...drawings.map((one) => one.corners.length),
  ].join();

/** Stores the open work. */
export function saveWork(state: EditorState, emit: Emit): EditorState {
  const work = snapshotOf(state);
  const { unread, step, key } = state.autosave;
  if (!work || (unread && !isWorkedOn(work))) return state;
  const now = stepKey(work);
  const unannounced = state.autosave.unannounced || now !== step;
  if (key !== null) emit({ type: 'store', work, recent: state.opening.recent, changed: unannounced });
  return withAutosave(state, { unread: false, step: now, unannounced, storing: key !== null });
}

/** Stores only the recent work. */
export function saveRecent(state: EditorState, emit: Emit): EditorState {
  const { recent } = state.opening;
  if (state.autosave.key !== null) emit({ type: 'store', work: null, recent, changed: false });
  return state;
}

/** Whether the browser holds the newest state of the open work. */
export const isKept = ({ autosave }: EditorState): boolean =>
  autosave.key !== null && !autosave.storing && !autosave.failing;

/**
 * Stores a picture that was just opened. Restored work is stored already, or newer work of another tab has replaced it.
 */
export const saveOpened = (state: EditorState, emit: Emit): EditorState =>
  state.autosave.restoring ? state : saveWork(state, emit);

export const autosaveHandlers: Handlers<
  'autosave-key-set' | 'work-stored' | 'other-tab-stored' | 'project-saved'
> = {
  'autosave-key-set': (state, { key }, emit) => {
    emit({ type: 'use-storage', key });
    return saveWork(withAutosave(state, { key, unread: false }), emit);
  },
  'work-stored': (before, { stored, newest }, emit) => {
    const state = newest ? withAutosave(before, { storing: false }) : before;
    if (stored === true) {
      const announces = newest && state.autosave.unannounced;
      if (announces) emit({ type: 'notify-tabs' });
      return withAutosave(state, {
        failing: false,
        ...(announces && { unannounced: false, overwritten: false }),
      });
    }
    const work = snapshotOf(state);
    // A picture that was opened and not touched is no loss.
    if (!work || !isWorkedOn(work) || state.autosave.failing) return state;
    const next = withAutosave(state, { failing: true });
    const text = stored === 'newer' ? say('notices.newerWork') : say('notices.notKept');
    return state.page.posable ? next : notify(next, { kind: 'error', text }, emit);
  },
  'project-saved': (state, { project }, emit) => {
    // Another picture may have been opened while the person chose a file.
    const isOpen = timeline(state.document.history).values.some(
      (document) => fileProject(document) === project,
    );
    return isOpen ? saveWork(withDocument(state, { saved: project }), emit) : state;
  },
  'other-tab-stored': (state, _, emit) => {
    const work = snapshotOf(state);
    if (state.autosave.overwritten || !work || !isWorkedOn(work)) return state;
    return inform(withAutosave(state, { overwritten: true }), say('notices.otherTab'), emit);
  },
};

export { withAutosave };
