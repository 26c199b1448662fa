/** Autosave: the work is stored under a key after each step, and tabs that share the key hear of it. */

import { recordOf } from '../../document/history';
import { drawingsOf } from '../../tools/machine';
import type { AutosaveState } from '../autosave_state';
import type { Emit } from '../effects';
import { NOT_KEPT, OVERWRITTEN } from '../notice_texts';
import type { EditorState } from '../state';
import { isWorkedOn, type Work, type WorkSnapshot } from '../work';
import type { Handlers } from './handlers';
import { inform, notify } from './notices';

const withAutosave = (state: EditorState, change: Partial<AutosaveState>): EditorState => ({
  ...state,
  autosave: { ...state.autosave, ...change },
});

export const workOf = ({ document, tools, view, pixelated }: EditorState): Work => ({
  record: recordOf(document.history),
  drawings: drawingsOf(tools),
  view,
  pixelated,
});

/** The open picture and its work; during a trial, the previous ones. */
export function snapshotOf(state: EditorState): WorkSnapshot | null {
  const { picture, opening, guard } = state;
  const open = opening.trial ? opening.trial.before : picture && { picture, work: workOf(state) };
  if (!open) return null;
  const { file, name } = open.picture;
  return { file, name, ...open.work, guarded: guard.on };
}

/** Identifies a step. Selecting something is no step. */
export const stepKey = ({ name, record: { past, future } }: WorkSnapshot): string =>
  [name, past.length, past.at(-1)?.label, future.length].join();

/** Stores the open work. */
export function saveWork(state: EditorState, emit: Emit): EditorState {
  const work = snapshotOf(state);
  const { unread, step, untold, key } = state.autosave;
  if (!work || (unread && !isWorkedOn(work))) return state;
  if (key !== null) emit({ type: 'store', work, parked: state.opening.parked });
  const now = stepKey(work);
  return withAutosave(state, { unread: false, step: now, untold: untold || now !== step });
}

/**
 * Stores a picture that was just opened. Restored work is stored already, or newer work of another tab has replaced it.
 */
export const saveOpened = (state: EditorState, emit: Emit): EditorState =>
  state.autosave.restoring ? state : saveWork(state, emit);

export const autosaveHandlers: Handlers<'autosave-key-set' | 'work-stored' | 'other-tab-stored'> = {
  'autosave-key-set': (state, { key }, emit) => {
    emit({ type: 'use-storage', key });
    return saveWork(withAutosave(state, { key, unread: false }), emit);
  },
  'work-stored': (state, { stored }, emit) => {
    if (stored) {
      if (state.autosave.untold) emit({ type: 'tell-tabs' });
      const told = state.autosave.untold ? { untold: false, overwritten: false } : {};
      return withAutosave(state, { failing: false, ...told });
    }
    const work = snapshotOf(state);
    // A picture that was opened and not touched is no loss.
    if (!work || !isWorkedOn(work) || state.autosave.failing) return state;
    const next = withAutosave(state, { failing: true });
    return state.page.playing ? next : notify(next, { kind: 'error', text: NOT_KEPT }, emit);
  },
  'other-tab-stored': (state, _, emit) => {
    const work = snapshotOf(state);
    if (state.autosave.overwritten || !work || !isWorkedOn(work)) return state;
    return inform(withAutosave(state, { overwritten: true }), OVERWRITTEN, emit);
  },
};

export { withAutosave };
