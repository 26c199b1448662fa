/** What is shown beside the document: overlays, previews, opened settings. */
import type { PreviewCommand } from '../commands';
import type { Emit } from '../effects';
import type { OverlayFlags, OverlayName } from '../overlays';
import type { Popover } from '../popover';
import { type DisplayState, type EditorState, selectionOf } from '../state';
import { hasSheet, refitView, showBox } from '../view';
import { keepPassing } from './notices';
import { withSolution } from './solve_request';

/** Only one heat map is shown. */
const REPLACES: Partial<Record<OverlayName, Partial<OverlayFlags>>> = {
  reach: { coverage: false, stiffness: false },
  coverage: { reach: false, stiffness: false },
  stiffness: { reach: false, coverage: false },
};

const withDisplay = (state: EditorState, change: Partial<DisplayState>): EditorState => ({
  ...state,
  display: { ...state.display, ...change },
});

export function switchOverlay(state: EditorState, overlay: OverlayName, on: boolean): EditorState {
  const { overlays } = state.display;
  return withDisplay(state, { overlays: { ...overlays, ...(on && REPLACES[overlay]), [overlay]: on } });
}

/** Shows the creases and zooms to the next one. */
export function zoomToCrease(state: EditorState): EditorState {
  const { creases } = state.checks;
  const next = (state.display.zoomedCrease + 1) % creases.length;
  const crease = creases[next];
  if (!crease) return state;
  return showBox(switchOverlay(withDisplay(state, { zoomedCrease: next }), 'creases', true), crease.box);
}

/** Shows the picture without handles while a key or button is held; null shows everything. */
export function holdPreview(state: EditorState, preview: PreviewCommand | null, emit: Emit): EditorState {
  if (preview === state.display.preview || (preview && !state.picture)) return state;
  // A preview hides the notice, which waits to be read.
  keepPassing(state, preview !== null, emit);
  return withDisplay(state, { preview });
}

export const togglePreview = (state: EditorState, preview: PreviewCommand, emit: Emit): EditorState =>
  holdPreview(state, state.display.preview === preview ? null : preview, emit);

export const openSettings = (state: EditorState, settings: boolean): EditorState =>
  refitView(withDisplay(state, { settings, overlayList: state.display.overlayList && !hasSheet(state) }));

/** Opens the list of overlays, which stays open until it is closed. It takes the place of the study card. */
export function openOverlays(state: EditorState, open: boolean, keyed: boolean, emit: Emit): EditorState {
  if (keyed) emit({ type: 'focus-control', control: open ? 'overlays' : 'overlay-button' });
  const settings = state.display.settings && !hasSheet(state);
  const study = open ? { ...state.study, page: null } : state.study;
  return refitView(withDisplay({ ...state, study }, { overlayList: open, settings }));
}

/**
 * Uncovers the numbers of the selected handles, since the sheet of a phone shows one thing. Closes the field
 * for the name of a handle that is no longer selected.
 */
export function showSelected(state: EditorState): EditorState {
  const { overlayList, renaming } = state.display;
  return withDisplay(state, {
    settings: false,
    overlayList: overlayList && !hasSheet(state),
    renaming: renaming && selectionOf(state).includes(renaming.id) ? renaming : null,
  });
}

export const openNumbers = (state: EditorState, numbers: boolean): EditorState =>
  withDisplay(state, { numbers });

/** A panel that opens closes the other one, before or after it says so itself. */
export function togglePopover(state: EditorState, popover: Popover, open: boolean): EditorState {
  if (open) return withDisplay(state, { popover });
  return state.display.popover === popover ? withDisplay(state, { popover: null }) : state;
}

/** Asks for the borders of the shown solution's cells, once they are to be shown. */
export function requestBorders(state: EditorState, emit: Emit): EditorState {
  const { shown, borders } = state.solution;
  const shows = state.display.overlays.cells || state.study.page === 'cells';
  if (!shows || state.page.posable || !shown || borders?.of === shown) return state;
  emit({ type: 'find-borders', solution: shown });
  return withSolution(state, { borders: { of: shown, pieces: null } });
}
