/** The tools by name, and the machine that keeps the state of the one in hand. */
import { hand } from './hand';
import { point } from './point';
import { select } from './select';
import type { Effect, Outcome, Press, Scene, State } from './state';

export const TOOLS = { select, point, hand } satisfies Record<string, State>;

export type ToolName = keyof typeof TOOLS;

export const isToolName = (name: unknown): name is ToolName => typeof name === 'string' && name in TOOLS;

export class ToolMachine {
  #tool: ToolName = 'select';
  #state: State = select;

  get tool(): ToolName {
    return this.#tool;
  }

  /** A press is held: between down and up or cancel. */
  get busy(): boolean {
    return this.#state !== TOOLS[this.#tool];
  }

  /** Takes up another tool; what the old one was about is cancelled. */
  choose(tool: ToolName): readonly Effect[] {
    const effects = this.cancel();
    this.#tool = tool;
    this.#state = TOOLS[tool];
    return effects;
  }

  /** A press. `once` takes it instead of the tool in hand: a space-drag pans, whatever the tool. */
  down(press: Press, scene: Scene, once: State = this.#state): readonly Effect[] {
    return this.#take(once.down?.(press, scene));
  }

  move(press: Press, scene: Scene): readonly Effect[] {
    return this.#take(this.#state.move?.(press, scene));
  }

  up(press: Press, scene: Scene): readonly Effect[] {
    const effects = this.#take(this.#state.up?.(press, scene));
    this.#state = TOOLS[this.#tool];
    return effects;
  }

  cancel(): readonly Effect[] {
    const effects = this.#take(this.#state.cancel?.());
    this.#state = TOOLS[this.#tool];
    return effects;
  }

  #take(result: Outcome | undefined): readonly Effect[] {
    if (!result) return [];
    this.#state = result.next;
    return result.effects;
  }
}
