/**
 * The tools by name, and the transitions of the current one.
 *
 * `Tools` is a value. Each transition returns the next value and the effects of the press, which the editor reduces.
 */
import { CORNERS_NEEDED } from '../document/handle';
import { brush } from './brush';
import { resumed } from './drafting';
import { hand } from './hand';
import { lasso } from './lasso';
import { lens } from './lens';
import { bar, polygon } from './lines';
import { point } from './point';
import { select } from './select';
import type { Draft, Effect, Outcome, Press, State, ToolContext } from './state';

export const TOOLS = { select, point, bar, polygon, lasso, brush, hand, lens } satisfies Record<
  string,
  State
>;

export type ToolName = keyof typeof TOOLS;

/** In the order of their buttons. */
export const TOOL_NAMES = Object.keys(TOOLS) as ToolName[];

export const isToolName = (name: unknown): name is ToolName =>
  typeof name === 'string' && Object.hasOwn(TOOLS, name);

/** Whether a tool draws a line from press to press. */
export const draws = (tool: ToolName): tool is Draft['kind'] => tool in CORNERS_NEEDED;

/** Tools that place nothing on the picture. */
const PLACELESS: readonly ToolName[] = ['select', 'hand', 'lens'];

/** Whether a tool places something on the picture. */
export const places = (tool: ToolName): boolean => !PLACELESS.includes(tool);

export interface Tools {
  readonly tool: ToolName;
  /** The state between presses: the tool itself, or its drawing. */
  readonly resting: State;
  readonly current: State;
}

export interface ToolsOutcome {
  readonly tools: Tools;
  readonly effects: readonly Effect[];
}

export const initialTools: Tools = { tool: 'select', resting: select, current: select };

/** Whether a press is in progress, between `pressDown` and `pressUp` or `cancelPress`. */
export const isPressing = ({ resting, current }: Tools): boolean => current !== resting;

/** Whether a press holds the selected handles. */
export const holdsHandles = ({ current }: Tools): boolean => current.holds === true;

/** The current tool's drawing, including the corner that is being set. */
export const draftOf = ({ resting, current }: Tools): Draft | null => current.draft ?? resting.draft ?? null;

/** The current tool's drawing, for `restoreDrawing`, without the current press. */
export const drawingOf = ({ resting }: Tools): Draft | null => resting.draft ?? null;

/** Whether there are corners to redo. */
export const hasTakenCorners = ({ resting }: Tools): boolean => resting.again !== undefined;

/** Selects another tool and cancels the current press. A drawing ends with its tool. */
export function chooseTool(before: Tools, tool: ToolName): ToolsOutcome {
  if (tool === before.tool) return cancelPress(before);
  const { tools, effects } = bailOut(before);
  return { tools: between({ ...tools, tool }, TOOLS[tool]), effects };
}

/** Starts a press. `once` handles it instead of the current tool: a space-drag pans with every tool. */
export const pressDown = (
  tools: Tools,
  press: Press,
  context: ToolContext,
  once = tools.current,
): ToolsOutcome => taken(tools, once.down?.(press, context));

export const pressMove = (tools: Tools, press: Press, context: ToolContext): ToolsOutcome =>
  taken(tools, tools.current.move?.(press, context));

export const pressUp = (tools: Tools, press: Press, context: ToolContext): ToolsOutcome =>
  rested(taken(tools, tools.current.up?.(press, context)));

/** Cancels the current press, as if it had not happened. */
export const cancelPress = (tools: Tools): ToolsOutcome =>
  isPressing(tools) ? rested(taken(tools, tools.current.cancel?.())) : { tools, effects: [] };

/** Cancels the current press and the drawing. */
export function bailOut(before: Tools): ToolsOutcome {
  const { tools, effects } = cancelPress(before);
  const ended: readonly Effect[] = draftOf(tools) ? [{ type: 'drafted', draft: null }] : [];
  return { tools: between(tools, TOOLS[tools.tool]), effects: [...effects, ...ended] };
}

/** Cancels the current press and replaces the drawing: by none, or by this one with its tool. */
export function restoreDrawing(before: Tools, draft: Draft | null = null): ToolsOutcome {
  const { tools, effects } = cancelPress(before);
  if (!draft) return { tools: between(tools, TOOLS[tools.tool]), effects };
  const tool = draft.kind;
  return { tools: between({ ...tools, tool }, resumed(draft, TOOLS[tool])), effects };
}

/** Moves the pointer without a press; null when it leaves. */
export function hover(tools: Tools, press: Press | null, context: ToolContext): Tools {
  const result = isPressing(tools) ? undefined : tools.current.hover?.(press, context);
  return result ? between(tools, result.next) : tools;
}

/** Finishes the drawing. */
export const finishDrawing = (tools: Tools, context: ToolContext): ToolsOutcome =>
  betweenPresses(tools, () => tools.resting.finish?.(context));

/** Takes back the last corner. */
export const takeBackCorner = (tools: Tools): ToolsOutcome =>
  betweenPresses(tools, () => tools.resting.back?.());

/** Redoes the corner that was taken back last. */
export const redoCorner = (tools: Tools): ToolsOutcome =>
  betweenPresses(tools, () => tools.resting.again?.());

/** Drops the corners to redo if no drawing is left. */
export const forgetTakenCorners = (tools: Tools): Tools =>
  draftOf(tools) || isPressing(tools) || !hasTakenCorners(tools) ? tools : between(tools, TOOLS[tools.tool]);

function betweenPresses(tools: Tools, ask: () => Outcome | undefined): ToolsOutcome {
  const result = isPressing(tools) ? undefined : ask();
  return result ? { tools: between(tools, result.next), effects: result.effects } : { tools, effects: [] };
}

/** The tools with `state` as the state between presses. */
const between = ({ tool }: Tools, state: State): Tools => ({ tool, resting: state, current: state });

/** Returns to the state between presses: a drawing continues, everything else ends. */
function rested({ tools, effects }: ToolsOutcome): ToolsOutcome {
  const { tool, resting, current } = tools;
  const continues = current === TOOLS[tool] || current.draft !== undefined;
  return { tools: between(tools, continues ? current : resting), effects };
}

const taken = (tools: Tools, result: Outcome | undefined): ToolsOutcome =>
  result ? { tools: { ...tools, current: result.next }, effects: result.effects } : { tools, effects: [] };
