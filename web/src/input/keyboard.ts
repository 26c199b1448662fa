/**
 * The keys of the editor while it has the focus. Text fields keep their keys, except document commands such as save.
 */

import type { EditorAccess } from '../editor/access';
import { type CommandName, commandOfKey, commandsFor, isPreview } from '../editor/commands';
import { holdsKeys } from '../editor/keys_in_hand';
import { selectionOf } from '../editor/state';
import { repeats, takesBail } from '../editor/update/command';
import { takesArrow, takesPlace, takesSpace, takesTurn } from '../editor/update/keys';
import { takesMenuKey } from '../editor/update/menu';
import type { Vec } from '../geometry/vec';
import { usesKey } from '../ui/own_keys';
import { isField, isTyped } from '../ui/untyped';

const ARROWS: Readonly<Record<string, Vec>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Commands of the document, run even from a text field. */
const OF_DOCUMENT: readonly CommandName[] = ['open', 'save', 'save-whole', 'export', 'export-as'];
/** Left to a text field while it has uncommitted input. */
const OF_HISTORY: readonly CommandName[] = ['undo', 'redo'];

/** Left to the browser, which then sends what is on the clipboard without asking anybody. */
const OF_CLIPBOARD: readonly CommandName[] = ['copy', 'paste', 'copy-keys', 'cut-keys', 'paste-keys'];

/** By `code`, since Shift changes `key`. */
const TURNS: Readonly<Record<string, number>> = { Comma: -1, Period: 1 };

export class KeyboardInput {
  readonly #root: ShadowRoot;
  readonly #editor: EditorAccess;
  readonly #listening = new AbortController();
  /** The `code` of the key of a held command: its `key` depends on the keyboard layout. */
  #held: string | null = null;

  constructor(root: ShadowRoot, editor: EditorAccess) {
    this.#root = root;
    this.#editor = editor;
    const { signal } = this.#listening;
    const compose = (event: Event) => this.#compose(event as KeyboardEvent);
    root.addEventListener('keydown', compose, { signal, capture: true });
    root.addEventListener('keyup', compose, { signal, capture: true });
    // :focus-visible also matches elements that a script focused before the first click.
    const keyed = (on: boolean) => root.host.classList.toggle('keyed', on);
    root.addEventListener('keydown', () => keyed(true), { signal });
    root.addEventListener('pointerdown', () => keyed(false), { signal });
    root.addEventListener('keydown', (event) => this.#hold(event as KeyboardEvent, true), { signal });
    root.addEventListener('keyup', (event) => this.#hold(event as KeyboardEvent, false), { signal });
    root.addEventListener('keydown', (event) => this.#down(event as KeyboardEvent), { signal });
    root.addEventListener('keyup', (event) => this.#up(event as KeyboardEvent), { signal });
    root.addEventListener('focusout', (event) => this.#releaseAll(event as FocusEvent), { signal });
  }

  dispose(): void {
    this.#listening.abort();
  }

  /** Keys of an input method are for its text. Safari sends the last one after the composition, with code 229. */
  #compose(event: KeyboardEvent): void {
    const { isComposing, keyCode, target } = event;
    if ((isComposing || keyCode === 229) && !this.#root.host.contains(target as Node))
      event.stopImmediatePropagation();
  }

  #down(event: KeyboardEvent): void {
    const target = event.target as Element;
    if (event.defaultPrevented || this.#editor.state.page.disabled) return;
    // Controls of the page, in the slots, have keys of their own.
    if (this.#root.host.contains(target)) return;
    // With Ctrl, the menu has just closed, and the key is processed further.
    if (target.closest('.context') && !event.ctrlKey && !event.metaKey) return;
    if (isField(target) && !this.#leavesField(event, target)) return;
    // The browser closes an open menu on Escape unless the event is cancelled.
    if (event.key === 'Escape' && this.#root.querySelector(':popover-open')) return;
    if (this.#record(event, true) || usesKey(target, event)) return;
    const { state, dispatch } = this.#editor;
    const onStage = target.matches('.shell, .stage, .stage *');
    const isAbout = onStage || selectionOf(state).length > 0;
    if ((isAbout && this.#selectionKey(event)) || (onStage && this.#stageKey(event, target))) {
      event.preventDefault();
      return;
    }
    const command = commandOfKey(
      event,
      commandsFor(state.page.posable, state.page.readonly, state.tools.tool, holdsKeys(state)),
    );
    if (command === null || OF_CLIPBOARD.includes(command)) return;
    if (command === 'bail') {
      if (!takesBail(state)) return;
      event.preventDefault();
      dispatch({ type: 'command-run', command });
      return;
    }
    event.preventDefault();
    if (event.repeat && !repeats(state, command)) return;
    if (!isPreview(command)) dispatch({ type: 'command-run', command });
    else if (!event.repeat) {
      this.#held = event.code;
      dispatch({ type: 'preview-held', command });
    }
  }

  /** Whether a key in a field is a document command; if so, commits the field first. */
  #leavesField(event: KeyboardEvent, field: Element): boolean {
    const command = event.ctrlKey || event.metaKey ? commandOfKey(event) : null;
    if (command === null) return false;
    if (OF_HISTORY.includes(command)) return !isTyped(field);
    if (!OF_DOCUMENT.includes(command)) return false;
    if (isTyped(field)) field.dispatchEvent(new Event('change'));
    return true;
  }

  /** Handles an arrow, or a key that turns or scales. Returns whether the key was one. */
  #selectionKey(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey) return false;
    const { state, dispatch } = this.#editor;
    const arrow = ARROWS[event.key];
    if (arrow) return this.#arrow(arrow, event);
    const turn = TURNS[event.code];
    const ten = event.shiftKey;
    if (turn === undefined || !takesTurn(state)) return false;
    if (event.altKey) dispatch({ type: 'turn-pressed', degrees: 0, scale: (ten ? 1.1 : 1.01) ** turn });
    else dispatch({ type: 'turn-pressed', degrees: turn * (ten ? 15 : 1), scale: 1 });
    return true;
  }

  #arrow([x, y]: Vec, { altKey, shiftKey }: KeyboardEvent): boolean {
    const { state, dispatch } = this.#editor;
    const steps = shiftKey ? 10 : 1;
    if (holdsKeys(state)) {
      if (!altKey) dispatch({ type: 'keys-walked', by: [x, y], extends: shiftKey });
      else if (x !== 0) dispatch({ type: 'keys-stepped', frames: x * steps });
      return true;
    }
    if (altKey || !takesArrow(state)) return false;
    dispatch({ type: 'arrow-pressed', by: [x * steps, y * steps] });
    return true;
  }

  /** Handles another key of the stage. Returns whether the key was one. */
  #stageKey(event: KeyboardEvent, target: Element): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const { state, dispatch } = this.#editor;
    if (event.key === 'ContextMenu' || (event.key === 'F10' && event.shiftKey)) {
      if (!takesMenuKey(state)) return false;
      dispatch({ type: 'menu-key-pressed' });
    } else if (event.key === ' ') return this.#holdSpace(true);
    else {
      if (event.key !== 'Enter' || !target.matches('.shell, .stage, .handle') || !takesPlace(state))
        return false;
      dispatch({ type: 'place-pressed' });
    }
    return true;
  }

  /** While R is held over an open timeline, a drag is recorded. Returns whether the key was handled. */
  #record(event: KeyboardEvent, held: boolean): boolean {
    const { state, dispatch } = this.#editor;
    const isHeld = held && state.timeline.open && !event.ctrlKey && !event.metaKey && !event.altKey;
    if (event.code !== 'KeyR' || (held && !isHeld)) return false;
    if (held) event.preventDefault();
    if (!event.repeat) dispatch({ type: 'record-held', held });
    return held;
  }

  #hold({ key, repeat }: KeyboardEvent, held: boolean): void {
    if (key === 'Alt' && !repeat) this.#editor.dispatch({ type: 'alt-held', held });
  }

  /** While Space is held, presses pan. Returns whether the key was handled. */
  #holdSpace(held: boolean): boolean {
    if (!takesSpace(this.#editor.state)) return false;
    this.#editor.dispatch({ type: 'space-held', held });
    return true;
  }

  #up(event: KeyboardEvent): void {
    this.#record(event, false);
    if (event.key === ' ') {
      const held = this.#holdSpace(false);
      // A focused button would be clicked by the release of Space.
      if (held && (event.target as Element).closest('.stage')) event.preventDefault();
    }
    if (event.code === this.#held) this.#editor.dispatch({ type: 'preview-held', command: null });
  }

  /** Without the focus no `keyup` arrives: held keys count as released. */
  #releaseAll({ relatedTarget }: FocusEvent): void {
    if (this.#root.contains(relatedTarget as Node | null)) return;
    this.#holdSpace(false);
    this.#editor.dispatch({ type: 'alt-held', held: false });
    this.#editor.dispatch({ type: 'record-held', held: false });
    this.#editor.dispatch({ type: 'preview-held', command: null });
  }
}
