/** The keys of the editor, heard only while it has the focus. Fields keep theirs, but for those of the document. */
import type { Vec } from '../geometry/vec';
import { type CommandName, commandOfKey } from '../ui/commands';
import { isTyped } from '../ui/untyped';

export interface KeyboardHost {
  /** People can do nothing. */
  readonly disabled: boolean;
  /** What keys may ask for: all others are the page's. */
  readonly commands: readonly CommandName[];
  run(command: CommandName): void;
  /** Escape. Returns whether there was anything to take back: if not, the key is the page's, for a dialog perhaps. */
  bail(): boolean;
  compare(on: boolean): void;
  /** Space is held over the picture: the next press pans. Returns, as those below, whether the key means anything here. */
  space(held: boolean): boolean;
  /** Arrow keys over the picture, in steps of 1 or, with Shift, 10. */
  arrow(by: Vec): boolean;
  /** Comma and full stop turn by 1° or, with Shift, 15°. */
  turn(degrees: number): boolean;
  /** Enter on the picture itself. */
  place(): boolean;
}

const ARROWS: Readonly<Record<string, Vec>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** What they ask for is meant for the document, wherever the keys are. */
const OF_DOCUMENT: readonly CommandName[] = ['open', 'save', 'export'];
/** These are the field's as long as something is typed into it. */
const OF_HISTORY: readonly CommandName[] = ['undo', 'redo'];

/** By the key's place, since Shift changes what it types. */
const TURNS: Readonly<Record<string, number>> = { Comma: -1, Period: 1 };

export class Keyboard {
  readonly #root: ShadowRoot;
  readonly #host: KeyboardHost;
  readonly #listening = new AbortController();
  /** The place of the key that holds the original up; what it types is another matter in every script. */
  #compares: string | null = null;

  constructor(root: ShadowRoot, host: KeyboardHost) {
    this.#root = root;
    this.#host = host;
    const { signal } = this.#listening;
    // The browser's own :focus-visible also holds for what a script focused before the first click.
    const keyed = (on: boolean) => root.host.classList.toggle('keyed', on);
    root.addEventListener('keydown', () => keyed(true), { signal });
    root.addEventListener('pointerdown', () => keyed(false), { signal });
    root.addEventListener('keydown', (event) => this.#down(event as KeyboardEvent), { signal });
    root.addEventListener('keyup', (event) => this.#up(event as KeyboardEvent), { signal });
    root.addEventListener('focusout', () => this.#letGo(), { signal });
  }

  release(): void {
    this.#listening.abort();
  }

  #down(event: KeyboardEvent): void {
    const target = event.target as Element;
    if (event.defaultPrevented || this.#host.disabled) return;
    if (target.matches('input:not([type=checkbox])') && !this.#leavesField(event, target)) return;
    // An open menu closes by itself, as long as nobody takes its key.
    if (event.key === 'Escape' && this.#root.querySelector(':popover-open')) return;
    const onStage = target.matches('.shell, .stage, .stage *');
    if (onStage && this.#stageKey(event, target)) {
      event.preventDefault();
      return;
    }
    const command = commandOfKey(event, this.#host.commands);
    if (command === null) return;
    if (command === 'bail') {
      if (this.#host.bail()) event.preventDefault();
      return;
    }
    event.preventDefault();
    if (command !== 'compare') this.#host.run(command);
    else if (!event.repeat) {
      this.#compares = event.code;
      this.#host.compare(true);
    }
  }

  /** Whether a key in a field is for the document; what is typed there is committed before. */
  #leavesField(event: KeyboardEvent, field: Element): boolean {
    const command = event.ctrlKey || event.metaKey ? commandOfKey(event) : null;
    if (command === null) return false;
    if (OF_HISTORY.includes(command)) return !isTyped(field);
    if (!OF_DOCUMENT.includes(command)) return false;
    if (isTyped(field)) field.dispatchEvent(new Event('change'));
    return true;
  }

  /** Keys that mean something over the picture only. Returns whether this did. */
  #stageKey(event: KeyboardEvent, target: Element): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const arrow = ARROWS[event.key];
    const turn = TURNS[event.code];
    const step = event.shiftKey;
    if (event.key === ' ') return this.#host.space(true);
    if (arrow) return this.#host.arrow([arrow[0] * (step ? 10 : 1), arrow[1] * (step ? 10 : 1)]);
    if (turn !== undefined) return this.#host.turn(turn * (step ? 15 : 1));
    return event.key === 'Enter' && target.matches('.shell, .stage') && this.#host.place();
  }

  #up(event: KeyboardEvent): void {
    if (event.key === ' ') {
      const held = this.#host.space(false);
      // A button with the focus would take the release for a click.
      if (held && (event.target as Element).closest('.stage')) event.preventDefault();
    }
    if (event.code === this.#compares) this.#host.compare(false);
  }

  /** A key let go elsewhere is never heard of. */
  #letGo(): void {
    this.#host.space(false);
    this.#host.compare(false);
  }
}
