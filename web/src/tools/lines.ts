/**
 * The bar tool (B) and the polygon tool (G): presses on the picture draw. Presses on point handles and selected handles
 * work as with the select tool, but a click on a ring draws.
 */
import { handleById } from '../document/document';
import { begun, type LineKind } from './drafting';
import { hit } from './hit';
import { pressed } from './pressing';
import type { Press, State, ToolContext } from './state';

function lineTool(kind: LineKind): State {
  const draws = (press: Press, context: ToolContext) => begun({ kind }, press, context, tool);
  const tool: State = {
    down: (press, context) => {
      const target = hit(context, press.at, false, press.alt);
      const handle = target && handleById(context.document, target.id);
      const taken = handle && (handle.kind === 'point' || context.document.selection.includes(handle.id));
      return target && taken ? pressed(target, press, context, tool, draws) : draws(press, context);
    },
  };
  return tool;
}

export const bar = lineTool('bar');
export const polygon = lineTool('polygon');
