/** The brush (F): a drag pushes, pinches, bloats, smooths, restores or stiffens the picture; with Alt the opposite. */
import { oppositeBrush } from './brush_kinds';
import { displace } from './displacing';
import type { State } from './state';
import { stiffen } from './stiffening';

export const brush: State = {
  down: (press, context) => {
    const own = press.alt ? oppositeBrush(context.brush) : context.brush;
    const { kind, ...rest } = own;
    return kind === 'stiffen'
      ? stiffen(press, rest, context)
      : displace(press, { ...rest, kind }, context, brush);
  },
};
