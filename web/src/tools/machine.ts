/** The tools by name, and the machine that holds the current tool and the state of each. */
import { CORNERS_NEEDED } from '../document/handle';
import { resumed } from './drafting';
import { hand } from './hand';
import { lasso } from './lasso';
import { bar, polygon } from './lines';
import { point } from './point';
import { select } from './select';
import type { Draft, Effect, Outcome, Press, State, ToolContext } from './state';

export const TOOLS = { select, point, bar, polygon, lasso, hand } satisfies Record<string, State>;

export type ToolName = keyof typeof TOOLS;

const NAMES = Object.keys(TOOLS) as ToolName[];

/** Unfinished drawings, one of each tool at most. */
export type Drawings = readonly Draft[];

export const isToolName = (name: unknown): name is ToolName =>
  typeof name === 'string' && Object.hasOwn(TOOLS, name);

/** Whether a tool draws something from press to press. */
export const draws = (tool: ToolName): tool is Draft['kind'] => tool in CORNERS_NEEDED;

/** Whether a tool places something on the picture. */
export const places = (tool: ToolName): boolean => tool !== 'select' && tool !== 'hand';

export class ToolMachine {
  #tool: ToolName = 'select';
  /** The states between presses: each tool itself, or its drawing, which waits while another tool is selected. */
  readonly #resting: Record<ToolName, State> = { ...TOOLS };
  #state: State = select;

  get tool(): ToolName {
    return this.#tool;
  }

  /** Whether a press is in progress, between `down` and `up` or `cancel`. */
  get busy(): boolean {
    return this.#state !== this.#resting[this.#tool];
  }

  /** Whether a press has the selected handles in hand. */
  get holds(): boolean {
    return this.#state.holds === true;
  }

  /** The current tool's drawing, including the corner that is being set. */
  get draft(): Draft | null {
    return this.#state.draft ?? this.#resting[this.#tool].draft ?? null;
  }

  /** Unfinished drawings of the other tools. */
  get waiting(): readonly Draft[] {
    return this.drawings.filter(({ kind }) => kind !== this.#tool);
  }

  /** All unfinished drawings, for `restore`, without the current press. */
  get drawings(): Drawings {
    return NAMES.flatMap((name) => this.#resting[name].draft ?? []);
  }

  /** Selects another tool and cancels the current press; a drawing waits. */
  choose(tool: ToolName): readonly Effect[] {
    const effects = this.cancel();
    if (tool === this.#tool) return effects;
    const { draft } = this;
    this.#settle(draft ? resumed(draft, TOOLS[this.#tool]) : TOOLS[this.#tool]);
    this.#tool = tool;
    this.#settle(this.#resting[tool]);
    return effects;
  }

  /** Starts a press. `once` handles it instead of the current tool: a space-drag pans with every tool. */
  down(press: Press, scene: ToolContext, once: State = this.#state): readonly Effect[] {
    return this.#take(once.down?.(press, scene));
  }

  move(press: Press, scene: ToolContext): readonly Effect[] {
    return this.#take(this.#state.move?.(press, scene));
  }

  up(press: Press, scene: ToolContext): readonly Effect[] {
    const effects = this.#take(this.#state.up?.(press, scene));
    this.#rest();
    return effects;
  }

  /** Cancels the current press, as if it had not happened. */
  cancel(): readonly Effect[] {
    if (!this.busy) return [];
    const effects = this.#take(this.#state.cancel?.());
    this.#rest();
    return effects;
  }

  /** Cancels the current press and the current tool's drawing. */
  bail(): readonly Effect[] {
    const effects = this.cancel();
    if (!this.draft) return effects;
    this.#settle(TOOLS[this.#tool]);
    return [...effects, { type: 'drafted', draft: null }];
  }

  /** Cancels the current press and the drawings of all tools. */
  clear(): readonly Effect[] {
    const waiting = this.waiting.length > 0 && !this.draft;
    const effects = this.bail();
    Object.assign(this.#resting, TOOLS);
    return waiting ? [...effects, { type: 'drafted', draft: null }] : effects;
  }

  /** Cancels the current press and replaces all drawings. */
  restore(drawings: Drawings = []): readonly Effect[] {
    const effects = this.cancel();
    Object.assign(this.#resting, TOOLS);
    for (const draft of drawings) this.#resting[draft.kind] = resumed(draft, TOOLS[draft.kind]);
    this.#state = this.#resting[this.#tool];
    return effects;
  }

  /** The pointer moves without a press, or leaves (null). */
  hover(press: Press | null, scene: ToolContext): void {
    if (this.busy) return;
    const result = this.#state.hover?.(press, scene);
    if (result) this.#settle(result.next);
  }

  /** Finishes the drawing. */
  finish(scene: ToolContext): readonly Effect[] {
    return this.#between(this.#resting[this.#tool].finish?.(scene));
  }

  /** Takes back the last corner. */
  back(): readonly Effect[] {
    return this.#between(this.#resting[this.#tool].back?.());
  }

  /** Whether there are corners to redo. */
  get takenBack(): boolean {
    return this.#resting[this.#tool].again !== undefined;
  }

  /** Redoes the corner that was taken back last. */
  again(): readonly Effect[] {
    return this.#between(this.#resting[this.#tool].again?.());
  }

  /** Drops the corners to redo if no drawing is left: undo or redo has gone on to other steps. */
  forget(): void {
    if (!this.draft && !this.busy) this.#settle(TOOLS[this.#tool]);
  }

  /** Resumes a drawing with its tool, unless another drawing or press has begun since. */
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

  /** Returns to the state between presses: a drawing continues, everything else is over. */
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
