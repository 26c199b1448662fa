import type { Emit } from '../effects';
import type { EditorEvent, EventOf } from '../events';
import type { EditorState } from '../state';

/** The transitions of some events. Effects go to `emit`, in order. */
export type Handlers<T extends EditorEvent['type']> = {
  readonly [E in T]: (state: EditorState, event: EventOf<E>, emit: Emit) => EditorState;
};
