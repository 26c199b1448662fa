/** Holds the state: an event makes the next one, the page renders it, and its effects are carried out. */
import type { EditorEffect } from '../editor/effects';
import type { EditorEvent } from '../editor/events';
import type { EditorState } from '../editor/state';
import { update } from '../editor/update';

export interface StoreListener {
  /** Called before the effects of the event. Effects may dispatch further events. */
  changed(state: EditorState, event: EditorEvent): void;
  /** Whether the page lets an event lead to the next state. It may dispatch other events meanwhile. */
  admits(before: EditorState, after: EditorState, event: EditorEvent): boolean;
  carryOut(effect: EditorEffect): void;
}

export class Store {
  readonly #listener: StoreListener;
  #state: EditorState;
  #disposed = false;

  constructor(state: EditorState, listener: StoreListener) {
    this.#state = state;
    this.#listener = listener;
  }

  get state(): EditorState {
    return this.#state;
  }

  readonly dispatch = (event: EditorEvent): void => {
    if (this.#disposed) return;
    const before = this.#state;
    let next = update(before, event);
    if (!this.#listener.admits(before, next.state, event)) return;
    // The page has changed something in its answer.
    if (this.#state !== before) next = update(this.#state, event);
    const { state, effects } = next;
    this.#state = state;
    this.#listener.changed(state, event);
    for (const effect of effects) if (!this.#disposed) this.#listener.carryOut(effect);
  };

  /** Ignores all later events. */
  dispose(): void {
    this.#disposed = true;
  }
}
