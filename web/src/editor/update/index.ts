/**
 * The one transition of the editor: a state and an event make the next state and effects.
 *
 * Pure: no DOM, clock, promise or random number. Each module beside this one handles the events of one subject.
 */
import { isPressing } from '../../tools/machine';
import type { EditorEffect, Emit } from '../effects';
import type { EditorEvent } from '../events';
import type { EditorState } from '../state';
import { waits } from '../waiting_input';
import { autosaveHandlers } from './autosave';
import { brushHandlers } from './brush';
import { clipKeyHandlers, followSelection } from './clip_keys';
import { followClip } from './clip_slice';
import { clipboardHandlers } from './clipboard';
import { clipHandlers } from './clips';
import { commandHandlers } from './command';
import { controlHandlers } from './controls';
import { requestBorders } from './display';
import { engineHandlers } from './engines';
import { exportHandlers } from './exporting';
import { showFilling } from './fill_request';
import { fillHandlers } from './filling';
import { filmHandlers } from './filming';
import { focusHandlers } from './focus';
import { graphicsHandlers, tellOfLostGraphics } from './graphics';
import type { Handlers } from './handlers';
import { keyHandlers } from './keys';
import { lassoHandlers } from './lasso';
import { lensHandlers, requestStudy } from './lens';
import { luminanceHandlers } from './luminance';
import { mapHandlers } from './maps';
import { menuHandlers } from './menu';
import { dismiss, noticeHandlers } from './notices';
import { pageHandlers } from './page';
import { followPlayback } from './playback';
import { playheadHandlers } from './playhead';
import { followCamera, pointerHandlers } from './pointer';
import { checkPose } from './pose_checks';
import { recentHandlers } from './recent';
import { recordingHandlers } from './recording';
import { renamingHandlers } from './renaming';
import { playOn, replayHandlers } from './replay';
import { requestEndHandlers } from './request_end';
import { requestHandlers } from './requests';
import { rigHandlers } from './rig';
import { showStage } from './solve_request';
import { solveHandlers } from './solve_results';
import { endMerging } from './steps';
import { studyHandlers } from './study';
import { showSuggesting, suggestionHandlers, withoutStaleSuggestion } from './suggesting';
import { reportTitle } from './title';
import { toolHandlers } from './tool_choice';
import { reportTool } from './tool_report';
import { trialHandlers } from './trial';
import { askForRelease, keepWaiting, waitingHandlers } from './waiting';
import { webPageHandlers } from './web_page';

const timerHandlers: Handlers<'timer-elapsed'> = {
  'timer-elapsed': (state, { timer }, emit) => {
    switch (timer) {
      case 'notice':
        return dismiss(state, emit);
      case 'solve-patience':
        return showStage(state, emit);
      case 'merge-end':
        return endMerging(state);
      case 'replay':
        return playOn(state, emit);
      case 'pose-check':
        return checkPose(state, emit);
      case 'fill-patience':
        return showFilling(state, emit);
      case 'suggest-patience':
        return showSuggesting(state, emit);
      case 'graphics':
        return tellOfLostGraphics(state);
    }
  },
};

const HANDLERS: Handlers<EditorEvent['type']> = {
  ...autosaveHandlers,
  ...brushHandlers,
  ...clipboardHandlers,
  ...clipHandlers,
  ...clipKeyHandlers,
  ...commandHandlers,
  ...controlHandlers,
  ...exportHandlers,
  ...filmHandlers,
  ...focusHandlers,
  ...graphicsHandlers,
  ...keyHandlers,
  ...lassoHandlers,
  ...lensHandlers,
  ...luminanceHandlers,
  ...menuHandlers,
  ...noticeHandlers,
  ...pageHandlers,
  ...playheadHandlers,
  ...pointerHandlers,
  ...recentHandlers,
  ...recordingHandlers,
  ...renamingHandlers,
  ...replayHandlers,
  ...requestEndHandlers,
  ...requestHandlers,
  ...rigHandlers,
  ...fillHandlers,
  ...solveHandlers,
  ...studyHandlers,
  ...suggestionHandlers,
  ...timerHandlers,
  ...toolHandlers,
  ...trialHandlers,
  ...waitingHandlers,
  ...engineHandlers,
  ...mapHandlers,
  ...webPageHandlers,
};

export interface Update {
  readonly state: EditorState;
  /** In the order in which the runtime carries them out. */
  readonly effects: readonly EditorEffect[];
}

export function update(before: EditorState, event: EditorEvent): Update {
  const effects: EditorEffect[] = [];
  const events: EditorEvent[] = [];
  const emit: Emit = (effect) => {
    if (effect.type === 'follow-up') events.push(effect.event);
    else effects.push(effect);
  };
  let state = before;
  if (waits(before, event)) state = keepWaiting(before, event, emit);
  else events.push(event);
  for (let next = events.shift(); next; next = events.shift()) state = reduce(state, next, emit);
  return { state: followPlayback(before, settled(state, emit), emit), effects };
}

function reduce(state: EditorState, event: EditorEvent, emit: Emit): EditorState {
  // Each handler takes the events of its own type, which the compiler cannot relate.
  const handle = HANDLERS[event.type] as (state: EditorState, event: EditorEvent, emit: Emit) => EditorState;
  return handle(state, event, emit);
}

/**
 * Follows from any state: the pose at the playhead, the hover under a moved camera, content of cards. So do the focus
 * on the selection, input to be released, guides that end, the title, and the tool.
 */
const settled = (before: EditorState, emit: Emit): EditorState => {
  const posed = withoutStaleSuggestion(followClip(withoutGuides(before), emit), emit);
  const shown = requestStudy(requestBorders(followCamera(posed), emit), emit);
  return reportTool(reportTitle(askForRelease(followSelection(shown, emit), emit), emit), emit);
};

/** Guides end with their press. */
const withoutGuides = (state: EditorState): EditorState =>
  state.display.guides.length > 0 && !isPressing(state.tools)
    ? { ...state, display: { ...state.display, guides: [] } }
    : state;
