/** The replay of Algorithm 1: its round, and playing through the rounds. */

import type { Emit } from '../effects';
import { roundsOf } from '../rounds_model';
import type { EditorState } from '../state';
import type { ReplayState } from '../study_state';
import type { Handlers } from './handlers';

/** A whole replay takes about this long. Few rounds take less, and many never go faster than eyes follow. */
const WHOLE_MS = 9000;
const STEP_MS = { least: 90, most: 700 } as const;

const withReplay = (state: EditorState, change: Partial<ReplayState>): EditorState => ({
  ...state,
  study: { ...state.study, replay: { ...state.study.replay, ...change } },
});

/** Goes to a round, and ends playing. */
function show(state: EditorState, round: number, emit: Emit): EditorState {
  const last = roundsOf(state.study).length - 1;
  emit({ type: 'stop-timer', timer: 'replay' });
  return withReplay(state, { round: Math.min(Math.max(round, 0), last), playing: false });
}

/** Plays on from the round on show; from the first one if that is the last. */
function play(state: EditorState, emit: Emit): EditorState {
  const last = roundsOf(state.study).length - 1;
  const { round } = state.study.replay;
  if (last < 1) return state;
  startStep(last, emit);
  return withReplay(state, { round: round === null || round >= last ? 0 : round, playing: true });
}

function startStep(rounds: number, emit: Emit): void {
  const ms = Math.min(Math.max(WHOLE_MS / rounds, STEP_MS.least), STEP_MS.most);
  emit({ type: 'start-timer', timer: 'replay', ms });
}

/** The next round, until the last or until another page is shown. */
export function playOn(state: EditorState, emit: Emit): EditorState {
  const { page, replay } = state.study;
  const last = roundsOf(state.study).length - 1;
  if (!replay.playing) return state;
  const round = (replay.round ?? 0) + 1;
  if (page !== 'rounds' || round > last) return withReplay(state, { playing: false });
  if (round < last) startStep(last, emit);
  return withReplay(state, { round, playing: round < last });
}

export const replayHandlers: Handlers<'round-shown' | 'replay-switched'> = {
  'round-shown': (state, { round }, emit) => show(state, round, emit),
  'replay-switched': (state, { on }, emit) =>
    on ? play(state, emit) : show(state, state.study.replay.round ?? 0, emit),
};
