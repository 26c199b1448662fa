/**
 * The bar tool (B) and the polygon tool (G): presses on the picture draw. A press on a point handle, or on anything
 * selected, works as with the select tool, but a click on a ring draws.
 */
import { handleById } from '../document/document';
import { begun, type LineKind } from './drafting';
import { hit } from './hit';
import { pressed } from './pressing';
import type { Press, Scene, State } from './state';

function lineTool(kind: LineKind): State {
  const draws = (press: Press, scene: Scene) => begun({ kind }, press, scene, tool);
  const tool: State = {
    down: (press, scene) => {
      const target = hit(scene, press.at, false);
      const handle = target && handleById(scene.document, target.id);
      const taken = handle && (handle.kind === 'point' || scene.document.selection.includes(handle.id));
      return target && taken ? pressed(target, press, scene, tool, draws) : draws(press, scene);
    },
  };
  return tool;
}

export const bar = lineTool('bar');
export const polygon = lineTool('polygon');
