/** The point tool (P): a press on the picture places a handle; on a handle or ring it does what select does. */
import { hit } from './hit';
import { placed } from './placing';
import { pressed } from './pressing';
import type { State } from './state';

export const point: State = {
  down: (press, scene) => {
    const target = hit(scene, press.at, false);
    return target ? pressed(target, press, scene, point) : placed(press, scene, point);
  },
};
