/** The controls of the panel, the bars and the drawing card. */
import { takeBackCorner } from '../../tools/machine';
import type { Emit } from '../effects';
import { mayEdit } from '../permissions';
import type { EditorState } from '../state';
import { contain, reveal } from '../view';
import { saveWork } from './autosave';
import { finish, focus } from './corners';
import {
  holdPreview,
  openNumbers,
  openOverlays,
  openSettings,
  switchOverlay,
  togglePopover,
  zoomToCrease,
} from './display';
import {
  setAutomatic,
  setBlend,
  setBoundaryHeld,
  setCornerField,
  setDetail,
  setEdges,
  setField,
  setPoseMode,
} from './edits';
import { switchFill } from './filling';
import { openExport } from './filming';
import type { Handlers } from './handlers';
import { removeLasso, setFeather } from './lasso';
import { applyTools } from './press';
import { select, toggleSelected } from './selection';

/** Applies an edit while people may change the document. */
const edit = (state: EditorState, change: () => EditorState): EditorState =>
  mayEdit(state) ? change() : state;

const setGuard = (state: EditorState, on: boolean, emit: Emit): EditorState =>
  saveWork({ ...state, guard: { ...state.guard, on, holding: false, asked: null } }, emit);

export const controlHandlers: Handlers<
  | 'preview-held'
  | 'overlay-switched'
  | 'field-set'
  | 'corner-field-set'
  | 'automatic-rotation-switched'
  | 'pose-mode-chosen'
  | 'detail-chosen'
  | 'blend-chosen'
  | 'lasso-removed'
  | 'boundary-switched'
  | 'edges-switched'
  | 'fill-switched'
  | 'feather-set'
  | 'outline-shown'
  | 'fold-guard-switched'
  | 'pixel-art-switched'
  | 'snapping-switched'
  | 'drawing-finished'
  | 'corner-taken-back'
  | 'theme-switched'
  | 'settings-opened'
  | 'numbers-opened'
  | 'popover-toggled'
  | 'overlays-opened'
  | 'handles-selected'
  | 'handle-toggled'
  | 'handle-focus-asked'
  | 'crease-zoomed'
  | 'place-revealed'
> = {
  'preview-held': (state, { command }, emit) => holdPreview(state, command, emit),
  'overlay-switched': (state, { overlay, on }) => switchOverlay(state, overlay, on),
  'field-set': (state, { field, change }, emit) => edit(state, () => setField(state, field, change, emit)),
  'corner-field-set': (state, { axis, change }, emit) => {
    const { corner } = state.focus;
    return corner ? edit(state, () => setCornerField(state, corner, axis, change, emit)) : state;
  },
  'automatic-rotation-switched': (state, { on }, emit) => edit(state, () => setAutomatic(state, on, emit)),
  'pose-mode-chosen': (state, { mode }, emit) => edit(state, () => setPoseMode(state, mode, emit)),
  'detail-chosen': (state, { detail }, emit) => edit(state, () => setDetail(state, detail, emit)),
  'blend-chosen': (state, { blend }, emit) => edit(state, () => setBlend(state, blend, emit)),
  'lasso-removed': (state, _, emit) => edit(state, () => removeLasso(state, emit)),
  'edges-switched': (state, { on }, emit) => edit(state, () => setEdges(state, on, emit)),
  'fill-switched': (state, { on }, emit) => edit(state, () => switchFill(state, on, emit)),
  'feather-set': (state, { change }, emit) => edit(state, () => setFeather(state, change, emit)),
  'boundary-switched': (state, { held }, emit) => edit(state, () => setBoundaryHeld(state, held, emit)),
  'outline-shown': (state, { on }) => ({ ...state, display: { ...state.display, outlined: on } }),
  'fold-guard-switched': (state, { on }, emit) => setGuard(state, on, emit),
  'pixel-art-switched': (state, { on }, emit) => saveWork({ ...state, pixelated: on }, emit),
  'snapping-switched': (state, { on }, emit) =>
    saveWork({ ...state, display: { ...state.display, snapping: on } }, emit),
  'drawing-finished': (state, _, emit) => edit(state, () => finish(state, emit)),
  'corner-taken-back': (state, _, emit) => applyTools(state, takeBackCorner(state.tools), emit),
  'theme-switched': (state, _, emit) => {
    emit({ type: 'set-theme', theme: state.media.dark ? 'light' : 'dark' });
    return state;
  },
  'settings-opened': (state, { open }) => openSettings(state, open),
  'numbers-opened': (state, { open }) => openNumbers(state, open),
  'popover-toggled': (state, { popover, open }, emit) => {
    const next = togglePopover(state, popover, open);
    return open && popover === 'export' ? openExport(next, emit) : next;
  },
  'overlays-opened': (state, { open, keyed }, emit) => openOverlays(state, open, keyed, emit),
  'handles-selected': (state, { ids }, emit) => select(state, ids, emit),
  'handle-toggled': (state, { id }, emit) => toggleSelected(state, id, emit),
  'handle-focus-asked': (state, { id }, emit) => {
    focus(emit, id);
    return state;
  },
  'crease-zoomed': zoomToCrease,
  'place-revealed': (state, { at }) => (state.page.posable ? contain(state, [at]) : reveal(state, at)),
};
