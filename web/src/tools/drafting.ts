/**
 * Drawing a bar, a polygon or a lasso: every press sets a corner, which follows the pointer until the release. The
 * presses of a lasso are in `stroking.ts`.
 *
 * A press on the last corner finishes the drawing, and so does a double click. A press on the first corner finishes a
 * polygon or lasso. One press, drag and release draws a whole bar. Shift snaps to steps of 45°. A cancelled press
 * removes only its own corners.
 */

import { ringsOf } from '../document/domain';
import { addHandle, freeId } from '../document/edits';
import { CORNERS_NEEDED, isClosed, isLine, rounded, roundedVec } from '../document/handle';
import type { LineHandle, Project } from '../document/project';
import { constrained } from '../geometry/polyline';
import { distance, type Vec } from '../geometry/vec';
import { say } from '../texts/wording';
import {
  type Draft,
  type Effect,
  type Outcome,
  outcome,
  type Press,
  type State,
  snappedPlace,
  type ToolContext,
} from './state';
import { aimed, closed, STEP_DEGREES, stroking, withoutStroke, withStroke } from './stroking';

export type LineKind = LineHandle['kind'];

export const isDrawable = ({ kind, corners }: Draft): boolean => corners.length >= CORNERS_NEEDED[kind];

/** The state between two presses of a drawing. `rest` is the state of the tool without a drawing. */
export function drafting(draft: Draft, rest: State): State {
  const state: State = {
    draft,
    down: (press, context) => {
      if (finishes(draft, press.at, context)) return outcome(finishing(draft, press, context, rest));
      // On the last corner, but there are too few corners to finish.
      if (onLast(draft, press.at, context)) return outcome(state);
      if (draft.kind === 'lasso') return outcome(stroke(draft, press, context, rest));
      const at = drawn(draft, press, context);
      return outcome(setting(draft, press, at, rest), ...missed(at, context));
    },
    hover: (press, context) => {
      const onFinish = press !== null && finishes(draft, press.at, context);
      if (draft.kind === 'lasso') {
        const end = !press || !onFinish ? 'none' : onFirst(draft, press.at, context) ? 'first' : 'last';
        return outcome(drafting(aimed(draft, press, context, end), rest));
      }
      const next = press && drawn(draft, press, context);
      return outcome(drafting({ ...draft, next, finishing: onFinish }, rest));
    },
    finish: (context) => (isDrawable(draft) ? finished(draft, context, rest) : outcome(state)),
    back: () => shortened(withoutStroke(draft), rest),
    ...lengthening(draft, rest),
  };
  return state;
}

/** Redoes the corner that was undone last, even if the drawing has no other corner. */
function lengthening(draft: Draft, rest: State): Pick<State, 'again'> {
  const last = draft.taken.at(-1);
  if (!last) return {};
  const longer: Draft = { ...withStroke(draft, last), taken: draft.taken.slice(0, -1) };
  return { again: () => outcome(drafting(longer, rest), { type: 'drafted', draft: longer }) };
}

/** Starts a drawing with its first press. */
export function begun(
  of: Pick<Draft, 'kind' | 'hole'>,
  press: Press,
  context: ToolContext,
  rest: State,
): Outcome {
  const strokes = of.kind === 'lasso' ? { strokes: [] } : {};
  const draft: Draft = { ...of, ...strokes, corners: [], taken: [], next: null, finishing: false };
  const selects = { type: 'select', ids: [] } as const;
  if (of.kind === 'lasso') return outcome(stroke(draft, press, context, rest), selects);
  const at = drawn(draft, press, context);
  return outcome(setting(draft, press, at, rest), selects, ...missed(at, context));
}

/** A press of a lasso. */
const stroke = (draft: Draft, press: Press, context: ToolContext, rest: State): State =>
  stroking(draft, press, context, {
    drawn: (after) => outcome(drafting(after, rest), { type: 'drafted', draft: after }),
    closed: (after, then) => finished(after, then, rest),
    cancelled: () => shortened(draft, rest, false),
  });

/** A corner of a bar or polygon outside of a lasso moves nothing. Elsewhere, the solver reports parts outside. */
function missed(at: Vec, context: ToolContext): readonly Effect[] {
  const bends = ringsOf(context.document.project).length === 0 || context.place(at);
  return bends ? [] : [{ type: 'miss', at }];
}

/** Resumes a drawing. */
export const resumed = (draft: Draft, rest: State): State =>
  drafting({ ...draft, next: null, path: [], finishing: false }, rest);

/** The state during a press. The new corner follows the pointer. A drag from the first corner draws a whole bar. */
const setting = (draft: Draft, from: Press, at: Vec, rest: State): State => {
  const first = draft.corners.length === 0;
  const anchored: Draft = first ? { ...draft, corners: [at] } : draft;
  const held = (corners: readonly Vec[]): State => {
    const after: Draft = { ...draft, corners, taken: [], next: null, finishing: false };
    const whole = first && corners.length > 1 && draft.kind === 'bar';
    return {
      draft: after,
      move: (press, context) => {
        if (distance(press.at, from.at) > context.grips.slop) {
          return outcome(held([...anchored.corners, drawn(anchored, press, context)]));
        }
        return outcome(held(first ? [at] : [...draft.corners, at]));
      },
      up: (_, context) =>
        whole
          ? finished(after, context, rest)
          : outcome(drafting(after, rest), { type: 'drafted', draft: after }),
      cancel: () => shortened(draft, rest, false),
    };
  };
  return held(first ? [at] : [...draft.corners, at]);
};

/** The state during a press that finishes the drawing on release. A second finger can still cancel it. */
const finishing = (draft: Draft, from: Press, begun: ToolContext, rest: State): State => ({
  draft,
  up: (_, context) => finished(draft, context, rest, !from.alt && onFirst(draft, from.at, begun)),
  cancel: () => outcome(drafting(draft, rest)),
});

function shortened(draft: Draft, rest: State, told = true): Outcome {
  const left = draft.corners.length > 0 ? draft : null;
  if (!told) return outcome(left ? drafting({ ...left, finishing: false }, rest) : rest);
  const next = left
    ? drafting({ ...left, finishing: false }, rest)
    : { ...rest, ...lengthening(draft, rest) };
  return outcome(next, { type: 'drafted', draft: left });
}

/** @param along a lasso that snaps to edges closes along them. Otherwise it closes by a straight line. */
function finished(draft: Draft, context: ToolContext, rest: State, along = false): Outcome {
  const { project } = context.document;
  const { kind, corners, hole = false } = draft;
  if (kind === 'lasso') {
    const lassoed = { type: 'lassoed', ring: closed(draft, context, along), hole } as const;
    return outcome(rest, { type: 'drafted', draft: null }, lassoed);
  }
  const handle = lineHandle(project, { kind, corners }, (places) => context.layerUnder(places));
  return outcome(
    rest,
    { type: 'begin', label: say(`steps.add.${kind}`) },
    { type: 'edit', document: addHandle(context.document, handle) },
    { type: 'commit' },
    { type: 'drawn', draft, handle },
  );
}

/**
 * Returns the handle of a drawing. It has the mean scale of the picture under its corners, so that the picture does not
 * jump.
 */
export function lineHandle(
  project: Project,
  { kind, corners }: { readonly kind: LineKind; readonly corners: readonly Vec[] },
  layerUnder: ToolContext['layerUnder'],
): LineHandle {
  const posed = corners.map(roundedVec);
  const placements = layerUnder(posed);
  const joints = project.handles.filter(isLine);
  const rest = placements.map(
    (placement, k) => jointAt(joints, posed[k] ?? placement.rest) ?? roundedVec(placement.rest),
  );
  const meanScale = placements.reduce((sum, { scale }) => sum + scale, 0) / Math.max(1, placements.length);
  return { id: freeId(project, kind), kind, rest, posed, rotation: 'auto', scale: rounded(meanScale) || 1 };
}

/** Returns the rest position of a corner that is posed at `at`, so that joined corners also meet at rest. */
function jointAt(handles: readonly LineHandle[], at: Vec): Vec | null {
  for (const { rest, posed } of handles) {
    const index = posed.findIndex((corner) => corner[0] === at[0] && corner[1] === at[1]);
    if (index >= 0) return rest[index] ?? null;
  }
  return null;
}

/**
 * Returns the position of the next corner. Shift snaps its direction. Otherwise it snaps to another handle's corner in
 * reach, or to guides, or else follows the pointer.
 */
function drawn({ corners }: Draft, press: Press, context: ToolContext): Vec {
  const last = corners.at(-1);
  if (press.shift && last) return constrained(last, press.at, STEP_DEGREES);
  const away = (corner: Vec) => distance(corner, press.at);
  const [nearest] = context.document.project.handles
    .filter(isLine)
    .flatMap(({ posed }) => posed)
    .sort((a, b) => away(a) - away(b));
  return nearest && away(nearest) <= context.grips.line
    ? nearest
    : snappedPlace(press.at, press, context, []).at;
}

const finishes = (draft: Draft, at: Vec, context: ToolContext): boolean =>
  isDrawable(draft) && (onFirst(draft, at, context) || onLast(draft, at, context));

function onFirst({ kind, corners }: Draft, at: Vec, { grips }: ToolContext): boolean {
  const [first] = corners;
  return isClosed(kind) && first !== undefined && distance(first, at) <= grips.handle;
}

function onLast({ corners }: Draft, at: Vec, { grips }: ToolContext): boolean {
  const last = corners.at(-1);
  return last !== undefined && distance(last, at) <= grips.line;
}
