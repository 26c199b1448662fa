/**
 * The point tool (P): a press on the picture places a handle. Presses on handles and drags of a ring work as with the
 * select tool.
 */
import { hit } from './hit';
import { placed } from './placing';
import { pressed } from './pressing';
import type { Press, State, ToolContext } from './state';

const places = (press: Press, context: ToolContext) => placed(press, context, point);

export const point: State = {
  down: (press, context) => {
    const target = hit(context, press.at, false, press.alt);
    return target ? pressed(target, press, context, point, places) : places(press, context);
  },
};
