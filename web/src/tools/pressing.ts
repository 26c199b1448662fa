/**
 * Pressing a handle or a ring, which becomes a click or a drag.
 *
 * A click selects. With Shift it adds to the selection or removes from it, with Alt it deletes the handle. A drag moves
 * the handles. On the ring or with Alt it turns them, on the grip it scales them, and on a corner it moves only the
 * corner. A click on a ring or grip applies to the object below.
 */

import { handleById } from '../document/document';
import { removeHandles } from '../document/edits';
import { anchor } from '../document/handle';
import { nameWords } from '../document/names';
import { distance } from '../geometry/vec';
import { say } from '../texts/wording';
import { cornering } from './cornering';
import { groupRing } from './group_ring';
import { type Hit, hit } from './hit';
import { moving } from './moving';
import { scaling } from './scaling';
import { type Effect, type Outcome, outcome, type Press, type State, type ToolContext } from './state';
import { turning } from './turning';

type Down = NonNullable<State['down']>;

/**
 * Starts a press on `target`. An unselected handle is selected at once. Everything else waits for the release.
 *
 * @param beneath handles a click on a ring, as if there were no rings. By default it selects.
 */
export function pressed(
  target: Hit,
  press: Press,
  context: ToolContext,
  rest: State,
  beneath: Down = selecting(rest),
): Outcome {
  const { selection } = context.document;
  const already = selection.includes(target.id);
  const effects: Effect[] = already
    ? []
    : [{ type: 'select', ids: press.shift ? [...selection, target.id] : [target.id] }];
  return outcome(pressing(target, press, already, rest, beneath), ...effects);
}

const selecting =
  (rest: State): Down =>
  ({ at, shift }, context) => {
    const target = hit(context, at);
    if (!target) return outcome(rest);
    const more = shift ? context.document.selection : [];
    return outcome(rest, { type: 'select', ids: [...more, target.id] });
  };

/** Returns the outcome of a press that is released at once. */
function atOnce(down: Down, press: Press, context: ToolContext): Outcome {
  const begun = down(press, context);
  const ended = begun.next.up?.(press, context);
  return ended ? outcome(ended.next, ...begun.effects, ...ended.effects) : begun;
}

const isOfRing = ({ part }: Hit): boolean => part === 'ring' || part === 'grip';

export const withoutRings = (context: ToolContext): ToolContext => ({
  ...context,
  grips: { ...context.grips, band: -1 },
});

const pressing = (target: Hit, from: Press, already: boolean, rest: State, beneath: Down): State => {
  const state: State = {
    holds: true,
    move: (press, context) => {
      if (distance(press.at, from.at) <= context.grips.slop) return outcome(state);
      return dragged(target, from, press, context, rest);
    },
    up: (press, context) => {
      if (isOfRing(target)) return atOnce(beneath, press, withoutRings(context));
      if (from.alt && press.alt && !context.posesOnly) return deleted(target, context, rest);
      if (!already) return outcome(rest);
      const { selection } = context.document;
      const ids = from.shift ? selection.filter((id) => id !== target.id) : [target.id];
      return outcome(rest, { type: 'select', ids });
    },
    cancel: () => outcome(rest),
  };
  return state;
};

function deleted({ id }: Hit, { document }: ToolContext, rest: State): Outcome {
  const handle = handleById(document, id);
  if (!handle) return outcome(rest);
  return outcome(
    rest,
    { type: 'begin', label: say('steps.delete', nameWords(handle)) },
    { type: 'edit', document: removeHandles(document, [id]) },
    { type: 'commit' },
  );
}

/** Starts a drag: opens an undo step and applies the first move. */
function dragged(target: Hit, from: Press, press: Press, context: ToolContext, rest: State): Outcome {
  const { document } = context;
  const handle = handleById(document, target.id);
  if (!handle) return outcome(rest);
  const ids = document.selection.includes(target.id) ? document.selection : [target.id];
  const alone = target.part === 'corner' && !from.alt;
  const who = ids.length > 1 && !alone ? say('names.handles', ids.length) : nameWords(handle);
  const ring = groupRing(document, context.grips);
  const pivot = ring?.pivot ?? anchor(handle);
  const aside = target.part === 'ring' || (ring && distance(pivot, from.at) > context.grips.handle);
  // A press on the pivot has no direction, so turns start from the first point of the drag.
  const hold = aside ? from.at : press.at;
  const [label, next] =
    target.part === 'grip' && ring
      ? [say('steps.scale', who), scaling(document, ring, from.at, rest)]
      : target.part === 'ring' || from.alt
        ? [say('steps.turn', who), turning(context, ids, pivot, hold, rest)]
        : target.part === 'corner'
          ? [say('steps.moveCorner', who), cornering(document, target.id, target.index, from.at, rest)]
          : [say('steps.move', who), moving(document, ids, anchor(handle), from.at, rest)];
  const first = next.move?.(press, context) ?? outcome(next);
  return outcome(first.next, { type: 'begin', label }, ...first.effects);
}
