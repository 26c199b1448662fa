/**
 * The point tool (P): a press on the picture places a handle. On a handle, and for drags of a ring, as the select tool.
 */
import { hit } from './hit';
import { placed } from './placing';
import { pressed } from './pressing';
import type { Press, Scene, State } from './state';

const places = (press: Press, scene: Scene) => placed(press, scene, point);

export const point: State = {
  down: (press, scene) => {
    const target = hit(scene, press.at, false);
    return target ? pressed(target, press, scene, point, places) : places(press, scene);
  },
};
