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

/** Unfinished drawings, at most one of each tool. */
export type Drawings = readonly Draft[];

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
  /** The states between presses: each tool itself, or its drawing, which waits while another tool is selected. */
  readonly resting: Readonly<Record<ToolName, State>>;
  readonly current: State;
}

export interface ToolsOutcome {
  readonly tools: Tools;
  readonly effects: readonly Effect[];
}

export const initialTools: Tools = { tool: 'select', resting: TOOLS, current: select };

/** Whether a press is in progress, between `pressDown` and `pressUp` or `cancelPress`. */
export const isPressing = ({ tool, resting, current }: Tools): boolean => current !== resting[tool];

/** Whether a press holds the selected handles. */
export const holdsHandles = ({ current }: Tools): boolean => current.holds === true;

/** The current tool's drawing, including the corner that is being set. */
export const draftOf = ({ tool, resting, current }: Tools): Draft | null =>
  current.draft ?? resting[tool].draft ?? null;

/** All unfinished drawings, for `restoreDrawings`, without the current press. */
export const drawingsOf = ({ resting }: Tools): Drawings =>
  TOOL_NAMES.flatMap((name) => resting[name].draft ?? []);

/** Unfinished drawings of the other tools. */
export const waitingDrafts = (tools: Tools): Drawings =>
  drawingsOf(tools).filter(({ kind }) => kind !== tools.tool);

/** Whether there are corners to redo. */
export const hasTakenCorners = ({ tool, resting }: Tools): boolean => resting[tool].again !== undefined;

/** Selects another tool and cancels the current press. A drawing waits. */
export function chooseTool(before: Tools, tool: ToolName): ToolsOutcome {
  const { tools, effects } = cancelPress(before);
  if (tool === tools.tool) return { tools, effects };
  const draft = draftOf(tools);
  const own = TOOLS[tools.tool];
  const left = between(tools, draft ? resumed(draft, own) : own);
  return { tools: { ...left, tool, current: left.resting[tool] }, effects };
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

/** Cancels the current press and the current tool's drawing. */
export function bailOut(before: Tools): ToolsOutcome {
  const { tools, effects } = cancelPress(before);
  if (!draftOf(tools)) return { tools, effects };
  return {
    tools: between(tools, TOOLS[tools.tool]),
    effects: [...effects, { type: 'drafted', draft: null }],
  };
}

/** Cancels the current press and the drawings of all tools. */
export function cancelAll(before: Tools): ToolsOutcome {
  const waiting = waitingDrafts(before).length > 0 && !draftOf(before);
  const { tools, effects } = bailOut(before);
  const { tool } = tools;
  const cleared: Tools = { tool, resting: TOOLS, current: TOOLS[tool] };
  return { tools: cleared, effects: waiting ? [...effects, { type: 'drafted', draft: null }] : effects };
}

/** Cancels the current press and replaces all drawings. */
export function restoreDrawings(before: Tools, drawings: Drawings = []): ToolsOutcome {
  const { tools, effects } = cancelPress(before);
  const restored = drawings.map((draft) => [draft.kind, resumed(draft, TOOLS[draft.kind])]);
  const resting: Tools['resting'] = { ...TOOLS, ...Object.fromEntries(restored) };
  return { tools: { tool: tools.tool, resting, current: resting[tools.tool] }, effects };
}

/** Moves the pointer without a press; null when it leaves. */
export function hover(tools: Tools, press: Press | null, context: ToolContext): Tools {
  const result = isPressing(tools) ? undefined : tools.current.hover?.(press, context);
  return result ? between(tools, result.next) : tools;
}

/** Finishes the drawing. */
export const finishDrawing = (tools: Tools, context: ToolContext): ToolsOutcome =>
  betweenPresses(tools, () => tools.resting[tools.tool].finish?.(context));

/** Takes back the last corner. */
export const takeBackCorner = (tools: Tools): ToolsOutcome =>
  betweenPresses(tools, () => tools.resting[tools.tool].back?.());

/** Redoes the corner that was taken back last. */
export const redoCorner = (tools: Tools): ToolsOutcome =>
  betweenPresses(tools, () => tools.resting[tools.tool].again?.());

/** Drops the corners to redo if no drawing is left. */
export const forgetTakenCorners = (tools: Tools): Tools =>
  draftOf(tools) || isPressing(tools) || !hasTakenCorners(tools) ? tools : between(tools, TOOLS[tools.tool]);

/** Resumes a drawing with its tool, unless another drawing or press has begun since. */
export function resumeDrawing(tools: Tools, draft: Draft): Tools {
  if (draftOf(tools) || isPressing(tools) || tools.resting[draft.kind].draft) return tools;
  return between({ ...tools, tool: draft.kind }, resumed(draft, TOOLS[draft.kind]));
}

function betweenPresses(tools: Tools, ask: () => Outcome | undefined): ToolsOutcome {
  const result = isPressing(tools) ? undefined : ask();
  return result ? { tools: between(tools, result.next), effects: result.effects } : { tools, effects: [] };
}

/** The tools with `state` as the state between presses. */
const between = (tools: Tools, state: State): Tools => ({
  tool: tools.tool,
  resting: { ...tools.resting, [tools.tool]: state },
  current: state,
});

/** Returns to the state between presses: a drawing continues, everything else ends. */
function rested({ tools, effects }: ToolsOutcome): ToolsOutcome {
  const { tool, resting, current } = tools;
  const continues = current === TOOLS[tool] || current.draft !== undefined;
  return { tools: between(tools, continues ? current : resting[tool]), effects };
}

const taken = (tools: Tools, result: Outcome | undefined): ToolsOutcome =>
  result ? { tools: { ...tools, current: result.next }, effects: result.effects } : { tools, effects: [] };
