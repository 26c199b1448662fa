/**
 * The lasso tool (L): draws a ring around a part of the original, which becomes the domain. Drags draw freely, and
 * presses set corners. Alt at the first press cuts a hole.
 *
 * Corners of the domain can be dragged, and a drag from an edge adds one. A press without a drag focuses a corner. On
 * an edge, and with Alt anywhere, it begins a new ring.
 */
import { begun } from './drafting';
import { ringPressing } from './ring_cornering';
import { ringHit } from './ring_hit';
import { outcome, type Press, type State, type ToolContext } from './state';

const draws = (press: Press, context: ToolContext) =>
  begun({ kind: 'lasso', hole: press.alt }, press, context, lasso);

export const lasso: State = {
  down: (press, context) => {
    const hit = press.alt ? null : ringHit(context.document.project, context.grips, press.at);
    if (!hit) return draws(press, context);
    return outcome(
      ringPressing(hit, press, lasso, () => {
        if (hit.part === 'corner') return outcome(lasso, { type: 'ring-focus', corner: hit });
        const begin = draws(press, context);
        const set = begin.next.up?.(press, context) ?? begin;
        return outcome(set.next, ...begin.effects, ...set.effects);
      }),
    );
  },
};
