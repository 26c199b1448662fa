/** Tools behind one mutable field, so that a test reads as a list of presses. */
import * as machine from './machine';
import type { Draft, Effect, Press, State, ToolContext } from './state';

export class TestTools {
  #tools = machine.initialTools;

  get tool(): machine.ToolName {
    return this.#tools.tool;
  }

  get busy(): boolean {
    return machine.isPressing(this.#tools);
  }

  get draft(): Draft | null {
    return machine.draftOf(this.#tools);
  }

  get drawing(): Draft | null {
    return machine.drawingOf(this.#tools);
  }

  get takenBack(): boolean {
    return machine.hasTakenCorners(this.#tools);
  }

  choose = (tool: machine.ToolName) => this.#next(machine.chooseTool(this.#tools, tool));
  down = (press: Press, context: ToolContext, once?: State) =>
    this.#next(machine.pressDown(this.#tools, press, context, once));
  move = (press: Press, context: ToolContext) => this.#next(machine.pressMove(this.#tools, press, context));
  up = (press: Press, context: ToolContext) => this.#next(machine.pressUp(this.#tools, press, context));
  cancel = () => this.#next(machine.cancelPress(this.#tools));
  bail = () => this.#next(machine.bailOut(this.#tools));
  restore = (drawing?: Draft | null) => this.#next(machine.restoreDrawing(this.#tools, drawing));
  finish = (context: ToolContext) => this.#next(machine.finishDrawing(this.#tools, context));
  back = () => this.#next(machine.takeBackCorner(this.#tools));
  again = () => this.#next(machine.redoCorner(this.#tools));

  hover(press: Press | null, context: ToolContext): void {
    this.#tools = machine.hover(this.#tools, press, context);
  }

  forget(): void {
    this.#tools = machine.forgetTakenCorners(this.#tools);
  }

  #next({ tools, effects }: machine.ToolsOutcome): readonly Effect[] {
    this.#tools = tools;
    return effects;
  }
}
