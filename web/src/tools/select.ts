/** The select tool (V): presses handles and rings, and draws a selection box over empty space. */
import { distance } from '../geometry/vec';
import { boxing } from './boxing';
import { hit } from './hit';
import { pressed } from './pressing';
import { outcome, type Press, type State } from './state';

export const select: State = {
  down: (press, scene) => {
    const target = hit(scene, press.at);
    if (target) return pressed(target, press, scene, select);
    return outcome(emptyPressing(press));
  },
};

/** Pressing empty space: a click clears the selection, or keeps it with Shift; a drag draws a box. */
const emptyPressing = (from: Press): State => {
  const state: State = {
    move: (press, scene) => {
      if (distance(press.at, from.at) <= scene.grips.slop) return outcome(state);
      const box = boxing(scene.document.selection, from.at, from.shift, select);
      return box.move?.(press, scene) ?? outcome(box);
    },
    up: () => (from.shift ? outcome(select) : outcome(select, { type: 'select', ids: [] })),
    cancel: () => outcome(select),
  };
  return state;
};
