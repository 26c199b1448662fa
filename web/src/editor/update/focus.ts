/** The focus inside the editor, as the page reports it. */
import type { Corner } from '../corner';
import type { Focus } from '../focus';
import type { EditorState } from '../state';
import type { Handlers } from './handlers';
import { withoutKeys } from './selection';

const withFocus = (state: EditorState, change: Partial<Focus>): EditorState => ({
  ...state,
  focus: { ...state.focus, ring: null, ...change },
});

const isSame = (a: Corner | null, b: Corner): boolean => a?.id === b.id && a.index === b.index;

export const focusHandlers: Handlers<
  | 'stage-focused'
  | 'field-focused'
  | 'control-focused'
  | 'key-focused'
  | 'focus-lost'
  | 'handle-focused'
  | 'corner-focused'
  | 'ring-focused'
> = {
  'stage-focused': (state) => withFocus(state, { on: 'stage', handle: null, corner: null }),
  // The panel is about the corner that had the focus before.
  'field-focused': (state) => withFocus(state, { on: 'field', handle: null }),
  'control-focused': (state) => withFocus(state, { on: 'control', handle: null }),
  'key-focused': (state) => withFocus(state, { on: 'key', handle: null, corner: null }),
  'focus-lost': (state) => withFocus(state, { on: 'nothing', handle: null }),
  // Whoever goes to a handle takes it.
  'handle-focused': (state, { id }) =>
    withFocus(withoutKeys(state), { on: 'handle', handle: id, corner: null }),
  'ring-focused': (state, { corner }) =>
    withFocus(withoutKeys(state), { on: 'ring', handle: null, corner: null, ring: corner }),
  'corner-focused': (state, { corner }) =>
    withFocus(withoutKeys(state), {
      on: 'corner',
      handle: corner.id,
      corner: isSame(state.focus.corner, corner) ? state.focus.corner : corner,
    }),
};
