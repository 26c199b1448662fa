/**
 * The keys of the editor while it has the focus. Text fields keep their keys, except document commands such as save.
 */
import type { Vec } from '../geometry/vec';
import { type CommandName, commandOfKey, commandsFor, isBareView } from '../ui/commands';
import { isField, isTyped } from '../ui/untyped';
import type { CommandRunner } from './command_runner';
import type { Display } from './display';
import type { Input } from './input';
import type { Permissions } from './permissions';
import type { StageKeys } from './stage_keys';

export interface KeyboardHost {
  readonly permissions: Permissions;
  readonly display: Display;
  readonly commands: CommandRunner;
  readonly stageKeys: StageKeys;
  readonly input: Input;
}

const ARROWS: Readonly<Record<string, Vec>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Commands of the document, run even from a text field. */
const OF_DOCUMENT: readonly CommandName[] = ['open', 'save', 'export', 'export-all'];
/** Left to a text field while it has uncommitted input. */
const OF_HISTORY: readonly CommandName[] = ['undo', 'redo'];

/** Left to the browser, which then sends what is on the clipboard without asking anybody. */
const OF_CLIPBOARD: readonly CommandName[] = ['copy', 'paste'];

/** By `code`, since Shift changes `key`. */
const TURNS: Readonly<Record<string, number>> = { Comma: -1, Period: 1 };

export class Keyboard {
  readonly #root: ShadowRoot;
  readonly #host: KeyboardHost;
  readonly #listening = new AbortController();
  /** The `code` of the key of a held command: its `key` depends on the keyboard layout. */
  #held: string | null = null;

  constructor(root: ShadowRoot, host: KeyboardHost) {
    this.#root = root;
    this.#host = host;
    const { signal } = this.#listening;
    // :focus-visible also matches elements that a script focused before the first click.
    const keyed = (on: boolean) => root.host.classList.toggle('keyed', on);
    root.addEventListener('keydown', () => keyed(true), { signal });
    root.addEventListener('pointerdown', () => keyed(false), { signal });
    root.addEventListener('keydown', (event) => this.#down(event as KeyboardEvent), { signal });
    root.addEventListener('keyup', (event) => this.#up(event as KeyboardEvent), { signal });
    root.addEventListener('focusout', (event) => this.#letGo(event as FocusEvent), { signal });
  }

  release(): void {
    this.#listening.abort();
  }

  #down(event: KeyboardEvent): void {
    const target = event.target as Element;
    if (event.defaultPrevented || this.#host.permissions.disabled) return;
    // With Ctrl the menu has just closed, and the key goes on.
    if (target.closest('.context') && !event.ctrlKey && !event.metaKey) return;
    if (isField(target) && !this.#leavesField(event, target)) return;
    // The browser closes an open menu on Escape unless the event is cancelled.
    if (event.key === 'Escape' && this.#root.querySelector(':popover-open')) return;
    const onStage = target.matches('.shell, .stage, .stage *');
    if (onStage && this.#stageKey(event, target)) {
      event.preventDefault();
      return;
    }
    const { permissions, commands, display } = this.#host;
    const command = commandOfKey(event, commandsFor(permissions.playing, permissions.readonly));
    if (command === null || OF_CLIPBOARD.includes(command)) return;
    if (command === 'bail') {
      if (commands.bail()) event.preventDefault();
      return;
    }
    event.preventDefault();
    // What is mirrored twice is as it was: a key held a little too long would end on either side.
    if (event.repeat && command === 'mirror') return;
    if (!isBareView(command)) commands.run(command);
    else if (!event.repeat) {
      this.#held = event.code;
      display.showBare(command);
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

  /** Handles keys of the stage. Returns whether the key was one. */
  #stageKey(event: KeyboardEvent, target: Element): boolean {
    if (event.ctrlKey || event.metaKey) return false;
    const turn = TURNS[event.code];
    const step = event.shiftKey;
    if (event.altKey) return turn !== undefined && this.#host.stageKeys.turn(0, (step ? 1.1 : 1.01) ** turn);
    const asksMenu = event.key === 'ContextMenu' || (event.key === 'F10' && step);
    if (asksMenu) return this.#host.stageKeys.menu();
    const arrow = ARROWS[event.key];
    if (event.key === ' ') return this.#host.input.space(true);
    if (arrow) return this.#host.stageKeys.arrow([arrow[0] * (step ? 10 : 1), arrow[1] * (step ? 10 : 1)]);
    if (turn !== undefined) return this.#host.stageKeys.turn(turn * (step ? 15 : 1));
    return event.key === 'Enter' && target.matches('.shell, .stage') && this.#host.stageKeys.place();
  }

  #up(event: KeyboardEvent): void {
    if (event.key === ' ') {
      const held = this.#host.input.space(false);
      // A focused button would be clicked by the release of Space.
      if (held && (event.target as Element).closest('.stage')) event.preventDefault();
    }
    if (event.code === this.#held) this.#host.display.showBare(null);
  }

  /** Without the focus no `keyup` arrives: held keys count as released. */
  #letGo({ relatedTarget }: FocusEvent): void {
    if (this.#root.contains(relatedTarget as Node | null)) return;
    this.#host.input.space(false);
    this.#host.display.showBare(null);
  }
}
