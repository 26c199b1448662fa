/** Changes by the page: attributes, device, size, and the methods of the element. */

import { openDocument } from '../../document/document';
import { addHandle, putHandles, removeHandles } from '../../document/edits';
import { say } from '../../texts/wording';
import { bailOut, cancelPress, isPressing } from '../../tools/machine';
import { hideCrosshair } from '../crosshair';
import type { Emit } from '../effects';
import type { PageAttributes } from '../page';
import { documentOf, type EditorState } from '../state';
import { fitView, refitView, resize, zoomTo } from '../view';
import { holdPreview } from './display';
import { withDocument } from './document_slice';
import { reset } from './edits';
import type { Handlers } from './handlers';
import { closeMenu } from './menu_closing';
import { pauseForPage, playForPage, rateForPage, seekForPage } from './playback';
import { openTimeline } from './playhead';
import { schedulePoseCheck } from './pose_checks';
import { applyTools } from './press';
import { withOpening } from './requests';
import { poseForPage, redo, selectForPage, step, undo } from './steps';
import { showStudy } from './study';
import { choose } from './tool_choice';

/** Takes the attributes. Setting `readonly` or `disabled`, or changing `posable`, ends the present action. */
function changePage(before: EditorState, page: PageAttributes, emit: Emit): EditorState {
  const { readonly, disabled, posable } = before.page;
  const rearranges = posable !== page.posable || (page.posable && readonly !== page.readonly);
  const locks = (page.readonly && !readonly) || (page.disabled && !disabled);
  const relocks =
    (page.readonly || page.disabled) && (readonly !== page.readonly || disabled !== page.disabled);
  const changesClip = page.clip !== before.page.clip;
  let state: EditorState = { ...before, page };
  if (changesClip) state = { ...state, playback: { ...state.playback, time: 0 } };
  if (locks || relocks || rearranges) state = stop(state, emit);
  return rearranges ? rearrange(state, emit) : state;
}

/** Ends a drag, a drawing, the menu and a preview. */
function stop(before: EditorState, emit: Emit): EditorState {
  const state = hideCrosshair(closeMenu(before, emit));
  emit({ type: 'leave-field' });
  const ended = applyTools(state, bailOut(state.tools), emit);
  return holdPreview(withDocument(ended, { drawn: null }), null, emit);
}

/** Adapts to `posable`: only the select tool poses handles, and the picture fits another stage. */
function rearrange(state: EditorState, emit: Emit): EditorState {
  const selecting = { ...state, page: { ...state.page, posable: false, readonly: false } };
  const chosen = state.page.posable ? choose(selecting, 'select', emit) : state;
  return schedulePoseCheck(fitView({ ...chosen, page: state.page }), emit);
}

export const pageHandlers: Handlers<
  | 'page-changed'
  | 'media-changed'
  | 'stage-resized'
  | 'tool-set'
  | 'handle-added'
  | 'handle-changed'
  | 'handle-removed'
  | 'handles-posed'
  | 'project-adopted'
  | 'page-project-set'
  | 'selection-set'
  | 'play-asked'
  | 'pause-asked'
  | 'autoplay-asked'
  | 'seek-asked'
  | 'rate-asked'
  | 'undo-asked'
  | 'redo-asked'
  | 'reset-asked'
  | 'fit-asked'
  | 'zoom-asked'
> = {
  'page-changed': (state, { page }, emit) => changePage(state, page, emit),
  'media-changed': (state, { media }) => {
    const next = { ...state, media };
    return media.rtl === state.media.rtl ? next : refitView(next);
  },
  'stage-resized': (before, { size, typing }, emit) => {
    // A hidden stage receives no more pointer moves.
    const isHidden = size.width === 0 || size.height === 0;
    const state = isHidden ? applyTools(before, cancelPress(before.tools), emit) : before;
    // An on-screen keyboard may change the height: the picture does not move for that, nor under a press.
    const keyboard = typing && state.pointer.coarse && size.width === state.stage.width;
    return resize(state, size, keyboard || isPressing(state.tools));
  },
  'tool-set': (state, { tool }, emit) =>
    tool === 'lens' && state.picture ? showStudy(state, 'lens', emit) : choose(state, tool, emit),
  'handle-added': (state, { handle }, emit) =>
    step(state, say('steps.addHandle'), addHandle(documentOf(state), handle), emit),
  'handle-changed': (state, { handle }, emit) =>
    step(state, say('steps.changeHandle'), putHandles(documentOf(state), [handle]), emit),
  'handle-removed': (state, { id }, emit) =>
    step(state, say('steps.deleteHandle'), removeHandles(documentOf(state), [id]), emit),
  'handles-posed': (state, { handles }, emit) => poseForPage(state, handles, emit),
  'project-adopted': (state, { project }, emit) =>
    step(withDocument(state, { saved: project }), say('steps.setProject'), openDocument(project), emit),
  'page-project-set': (state, { project }) => withOpening(state, { pageProject: project }),
  'selection-set': (state, { ids }, emit) =>
    state.picture && state.opening.revision === state.opening.openedRevision
      ? selectForPage(state, ids, emit)
      : withOpening(state, { pageSelection: ids }),
  'play-asked': (state, _, emit) => playForPage(openTimeline(state, false, emit), emit),
  'pause-asked': (state, _, emit) => pauseForPage(state, emit),
  // For people who prefer reduced motion, nothing plays automatically.
  'autoplay-asked': (state, _, emit) =>
    state.page.autoplay && !state.media.still ? playForPage(state, emit) : state,
  'seek-asked': (state, { time }, emit) => seekForPage(openTimeline(state, false, emit), time, emit),
  'rate-asked': (state, { rate }) => rateForPage(state, rate),
  'undo-asked': (state, _, emit) => undo(state, emit),
  'redo-asked': (state, _, emit) => redo(state, emit),
  'reset-asked': (state, _, emit) => reset(state, true, emit),
  'fit-asked': (state) => fitView(state),
  'zoom-asked': (state, { scale }) => zoomTo(state, scale),
};
