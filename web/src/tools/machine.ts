/** The tools by name, and the machine that keeps the state of each and knows the one in hand. */
import { resumed } from './drafting';
import { hand } from './hand';
import { bar, polygon } from './lines';
import { point } from './point';
import { select } from './select';
import type { Draft, Effect, Outcome, Press, Scene, State } from './state';

export const TOOLS = { select, point, bar, polygon, hand } satisfies Record<string, State>;

export type ToolName = keyof typeof TOOLS;

const NAMES = Object.keys(TOOLS) as ToolName[];

/** What each tool draws, or the tool itself. */
export type Drawings = Readonly<Record<ToolName, State>>;

export const isToolName = (name: unknown): name is ToolName => typeof name === 'string' && name in TOOLS;

export class ToolMachine {
  #tool: ToolName = 'select';
  /** Between presses: each tool itself, or what is being drawn with it. That waits while another tool is in hand. */
  readonly #resting: Record<ToolName, State> = { ...TOOLS };
  #state: State = select;

  get tool(): ToolName {
    return this.#tool;
  }

  /** A press is held: between down and up or cancel. */
  get busy(): boolean {
    return this.#state !== this.#resting[this.#tool];
  }

  /** What is being drawn, with the corner in hand. */
  get draft(): Draft | null {
    return this.#state.draft ?? this.#resting[this.#tool].draft ?? null;
  }

  /** What is being drawn with other tools, until they are taken up again. */
  get waiting(): readonly Draft[] {
    return NAMES.flatMap((name) => (name === this.#tool ? [] : (this.#resting[name].draft ?? [])));
  }

  /** All that is being drawn, to be put back by `restore`; a press in hand is no part of it. */
  get drawings(): Drawings {
    return { ...this.#resting };
  }

  /** Takes up another tool; the press in hand is over, what is being drawn waits. */
  choose(tool: ToolName): readonly Effect[] {
    const effects = this.cancel();
    if (tool === this.#tool) return effects;
    const { draft } = this;
    this.#settle(draft ? resumed(draft, TOOLS[this.#tool]) : TOOLS[this.#tool]);
    this.#tool = tool;
    this.#settle(this.#resting[tool]);
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
    this.#rest();
    return effects;
  }

  /** The press in hand is over, as if it had not been. */
  cancel(): readonly Effect[] {
    if (!this.busy) return [];
    const effects = this.#take(this.#state.cancel?.());
    this.#rest();
    return effects;
  }

  /** Gives up the press in hand, and what is being drawn. */
  bail(): readonly Effect[] {
    const effects = this.cancel();
    if (!this.draft) return effects;
    this.#settle(TOOLS[this.#tool]);
    return [...effects, { type: 'drafted', draft: null }];
  }

  /** The same, with what waits for other tools. */
  clear(): readonly Effect[] {
    const effects = this.bail();
    Object.assign(this.#resting, TOOLS);
    return effects;
  }

  /** Gives up the press in hand, and puts these in the place of what is being drawn. */
  restore(drawings: Drawings = TOOLS): readonly Effect[] {
    const effects = this.cancel();
    Object.assign(this.#resting, drawings);
    this.#state = this.#resting[this.#tool];
    return effects;
  }

  /** The pointer goes by, or has left. */
  hover(press: Press | null, scene: Scene): void {
    if (this.busy) return;
    const result = this.#state.hover?.(press, scene);
    if (result) this.#settle(result.next);
  }

  /** The drawing is done. */
  finish(scene: Scene): readonly Effect[] {
    return this.#between(this.#resting[this.#tool].finish?.(scene));
  }

  /** Takes the last corner back. */
  back(): readonly Effect[] {
    return this.#between(this.#resting[this.#tool].back?.());
  }

  /** There are corners that were taken back and can come again. */
  get takenBack(): boolean {
    return this.#resting[this.#tool].again !== undefined;
  }

  /** Brings the last of them again. */
  again(): readonly Effect[] {
    return this.#between(this.#resting[this.#tool].again?.());
  }

  /** A drawing that was taken back altogether is over: something before it is taken back. */
  forget(): void {
    if (!this.draft && !this.busy) this.#settle(TOOLS[this.#tool]);
  }

  /** Goes on with a drawing, with its tool, unless something else is being drawn by now. */
  resume(draft: Draft): void {
    if (this.draft || this.busy || this.#resting[draft.kind].draft) return;
    this.#tool = draft.kind;
    this.#settle(resumed(draft, TOOLS[this.#tool]));
  }

  #between(result: Outcome | undefined): readonly Effect[] {
    if (this.busy || !result) return [];
    this.#settle(result.next);
    return result.effects;
  }

  #settle(state: State): void {
    this.#resting[this.#tool] = state;
    this.#state = state;
  }

  /** After a press: what is drawn goes on, everything else is over. */
  #rest(): void {
    const lasts = this.#state === TOOLS[this.#tool] || this.#state.draft !== undefined;
    this.#settle(lasts ? this.#state : this.#resting[this.#tool]);
  }

  #take(result: Outcome | undefined): readonly Effect[] {
    if (!result) return [];
    this.#state = result.next;
    return result.effects;
  }
}
