/**
 * One press of a lasso. A click sets a corner, at the end of a straight line or of a path along edges. A drag draws
 * freely, and is simplified to few corners. A drag that ends at the first corner closes the lasso. So does a first drag
 * that comes back near its beginning.
 *
 * If the lasso snaps to edges, drags follow those that are near. Alt suspends that.
 */
import { constrained, distanceToLine, lengthOf } from '../geometry/polyline';
import { simplified, withoutWhiskers } from '../geometry/polyline_simplified';
import { withoutCurls } from '../geometry/ring';
import { distance, type Vec } from '../geometry/vec';
import { type Draft, type Outcome, outcome, type Press, type State, type ToolContext } from './state';

/** The step of directions with Shift, degrees. */
export const STEP_DEGREES = 45;

/** Sizes in multiples of `Grips.slop`: between places of a drag; how far corners may cut; between snapped places. */
const SPACING = 1;
const TOLERANCE = 0.5;
const SNAP_SPACING = 12;
/** Edges farther than this from a drag are ignored. */
const SNAP_REACH = 4;

/** The longest whisker. */
const WHISKER = 8;

/** The longest loop that is a curl: in multiples of `Grips.slop`, or as a part of the outline. */
const CURL = { least: 16, part: 0.04 } as const;

/** The gap that a first drag may leave, as a fraction of its length. */
const GAP = 0.1;

/** What follows a press. */
export interface AfterStroke {
  drawn(draft: Draft): Outcome;
  closed(draft: Draft, context: ToolContext): Outcome;
  cancelled(): Outcome;
}

/** Adds the corners of one press. */
export const withStroke = (draft: Draft, corners: readonly Vec[]): Draft => ({
  ...draft,
  corners: [...draft.corners, ...corners],
  ...(draft.strokes && { strokes: [...draft.strokes, corners.length] }),
  next: null,
  finishing: false,
});

/** Takes back the corners of the last press. */
export function withoutStroke(draft: Draft): Draft {
  const { corners, strokes, taken } = draft;
  const left = Math.max(0, corners.length - (strokes?.at(-1) ?? 1));
  return {
    ...draft,
    corners: corners.slice(0, left),
    ...(strokes && { strokes: strokes.slice(0, -1) }),
    taken: [...taken, corners.slice(left)],
    path: [],
  };
}

/**
 * The drawing under a pointer between two presses, with the way to it.
 *
 * @param end the effect of a press there: it continues, closes the outline at its first corner, or ends it at the last.
 */
export function aimed(
  draft: Draft,
  press: Press | null,
  context: ToolContext,
  end: 'none' | 'first' | 'last',
): Draft {
  if (!press) return { ...draft, next: null, path: [], finishing: false };
  if (end !== 'none') {
    const path = end === 'first' && !press.alt ? closing(draft, context, false) : [];
    return { ...draft, next: press.at, path, finishing: true };
  }
  const way = wayTo(draft, press, context, false);
  return { ...draft, next: way.at(-1) ?? press.at, path: way.slice(0, -1), finishing: false };
}

/** The places between the last corner and the first, along edges if the lasso snaps to them. */
function closing({ corners }: Draft, { trace }: ToolContext, precise: boolean): readonly Vec[] {
  const [first] = corners;
  return first && trace ? trace(corners, first, precise).slice(0, -1) : [];
}

/**
 * The whole outline. Whiskers of paths along edges go, and curls of the hand. Where presses end, their corners stay.
 *
 * @param along the way back to the first corner follows edges too.
 */
export function closed(draft: Draft, context: ToolContext, along: boolean): readonly Vec[] {
  const { grips, trace } = context;
  const ring = [...draft.corners, ...(along ? closing(draft, context, true) : [])];
  const kept = pressedCorners(draft);
  const smooth = trace ? withoutWhiskers(ring, WHISKER * grips.slop, kept) : ring;
  return withoutCurls(smooth, Math.max(CURL.least * grips.slop, CURL.part * lengthOf(ring)), kept);
}

/** The last corner of each press. */
function pressedCorners({ corners, strokes = [] }: Draft): ReadonlySet<Vec | undefined> {
  let count = 0;
  return new Set(
    strokes.map((own) => {
      count += own;
      return corners[count - 1];
    }),
  );
}

function wayTo({ corners }: Draft, press: Press, { trace }: ToolContext, precise: boolean): readonly Vec[] {
  const last = corners.at(-1);
  if (press.shift && last) return [constrained(last, press.at, STEP_DEGREES)];
  return trace && !press.alt ? trace(corners, press.at, precise) : [press.at];
}

/** The state during a press. */
export function stroking(draft: Draft, from: Press, context: ToolContext, then: AfterStroke): State {
  const start = wayTo(draft, from, context, true);
  const fresh: Draft = { ...draft, taken: [], path: [] };

  const clicking = (way: readonly Vec[]): State => {
    const after = withStroke(fresh, way);
    return {
      draft: after,
      move: (press, now) => {
        if (distance(press.at, from.at) <= now.grips.slop) return outcome(clicking(way));
        return press.shift
          ? outcome(clicking(wayTo(draft, press, now, true)))
          : outcome(dragging([start.at(-1) ?? from.at, press.at]));
      },
      up: () => then.drawn(after),
      cancel: then.cancelled,
    };
  };

  const dragging = (path: readonly Vec[]): State => ({
    draft: withStroke(fresh, [...start, ...path.slice(1)]),
    move: ({ at }, { grips }) => {
      const [last = at] = path.slice(-1);
      return outcome(dragging(distance(at, last) > SPACING * grips.slop ? [...path, at] : path));
    },
    up: ({ at, alt }, now) => {
      const whole = distance(path.at(-1) ?? at, at) > 0 ? [...path, at] : path;
      const corners = followed([...draft.corners, ...start], whole, now, alt);
      const after = withStroke(fresh, [...start, ...corners]);
      // Where such a drag ends is no corner that was set: it may overshoot the first one.
      const ended = { ...after, strokes: draft.strokes ?? [] };
      return closes(after, draft, now) ? then.closed(ended, now) : then.drawn(after);
    },
    cancel: then.cancelled,
  });

  return clicking(start);
}

/** Whether a drag has come back to the first corner. */
function closes(after: Draft, before: Draft, { grips }: ToolContext): boolean {
  const [first, last] = [after.corners[0], after.corners.at(-1)];
  if (!first || !last || after.corners.length < 3) return false;
  const room = before.corners.length === 0 ? GAP * lengthOf(after.corners) : 0;
  return distance(first, last) <= Math.max(grips.handle, room);
}

/** A drag in few corners, each piece along an edge that is near all of it. It begins at the last of some corners. */
function followed(
  corners: readonly Vec[],
  path: readonly Vec[],
  { grips, trace }: ToolContext,
  free: boolean,
): readonly Vec[] {
  const freely = (piece: readonly Vec[]) => simplified(piece, TOLERANCE * grips.slop).slice(1);
  if (!trace || free) return freely(path);
  const all = [...corners];
  for (const piece of pieces(path, SNAP_SPACING * grips.slop)) {
    const way = trace(all, piece.at(-1) ?? [0, 0], true);
    const isNear = way.every((at) => distanceToLine(piece, false, at) <= SNAP_REACH * grips.slop);
    all.push(...(isNear ? way : freely(piece)));
  }
  return all.slice(corners.length);
}

/** Cuts a line into pieces of about a length, each beginning with the last place of the one before. */
function pieces(path: readonly Vec[], length: number): readonly (readonly Vec[])[] {
  const count = Math.max(1, Math.round(lengthOf(path) / length));
  const each = lengthOf(path) / count;
  const cut: Vec[][] = [];
  let [piece, far]: [Vec[], number] = [[], 0];
  path.forEach((at, k) => {
    far += k > 0 ? distance(path[k - 1] ?? at, at) : 0;
    piece.push(at);
    if (far < each && k < path.length - 1) return;
    if (piece.length > 1) cut.push(piece);
    [piece, far] = [[at], 0];
  });
  return cut;
}
