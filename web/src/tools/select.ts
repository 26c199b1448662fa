/** The select tool (V): presses handles and rings, and draws a selection box over empty space. */
import { distance } from '../geometry/vec';
import { boxing } from './boxing';
import { hit } from './hit';
import { pressed } from './pressing';
import { outcome, type Press, type State } from './state';

export const select: State = {
  down: (press, context) => {
    const target = hit(context, press.at, true, press.alt);
    if (target) return pressed(target, press, context, select);
    return outcome(emptyPressing(press));
  },
};

/** Pressing empty space: a click clears the selection, or keeps it with Shift; a drag draws a box. */
const emptyPressing = (from: Press): State => {
  const state: State = {
    move: (press, context) => {
      if (distance(press.at, from.at) <= context.grips.slop) return outcome(state);
      const box = boxing(context.document.selection, from.at, from.shift, select);
      return box.move?.(press, context) ?? outcome(box);
    },
    up: () => (from.shift ? outcome(select) : outcome(select, { type: 'select', ids: [] })),
    cancel: () => outcome(select),
  };
  return state;
};
