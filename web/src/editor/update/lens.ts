/** The lens: its point, and the questions about it. */

import { selectedHandles } from '../../document/document';
import { anchor } from '../../document/handle';
import { toImage } from '../../geometry/camera';
import type { Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import { crosshairMoved } from '../crosshair';
import type { Emit } from '../effects';
import type { EventOf } from '../events';
import { toolContext } from '../hit_areas';
import { lensWords } from '../lens_words';
import type { Solution } from '../solution';
import { documentOf, type EditorState, projectOf } from '../state';
import type { LensState, StudyState } from '../study_state';
import { viewMiddle } from '../view';
import type { Handlers } from './handlers';
import { announce } from './notices';

export const withStudy = (state: EditorState, change: Partial<StudyState>): EditorState => ({
  ...state,
  study: { ...state.study, ...change },
});

const withLens = (state: EditorState, change: Partial<LensState>): EditorState =>
  withStudy(state, { lens: { ...state.study.lens, ...change } });

/** Looks at a place of the posed picture, if something bends there. */
function lookAt(state: EditorState, posed: Vec, change: Partial<LensState>): EditorState {
  const rest = toolContext(state).place(posed)?.rest;
  return rest ? withLens(state, { ...change, at: rest, site: null }) : state;
}

/** A person points at a place: the lens stays there. */
export const look = (state: EditorState, posed: Vec): EditorState =>
  lookAt(state, posed, { pinned: true, speaks: true });

/** The lens follows the resting pointer until it is pinned. */
export const followPointer = (state: EditorState): EditorState => {
  const { pointer, tools, study } = state;
  const follows = tools.tool === 'lens' && study.page === 'lens' && !study.lens.pinned;
  return follows && pointer.hovered ? lookAt(state, pointer.hovered, {}) : state;
};

/** Looks at the pointer, else at a selected handle, else at the middle of the view. */
export function beginLooking(state: EditorState): EditorState {
  const [selected] = selectedHandles(documentOf(state));
  const place =
    state.pointer.hovered ?? (selected ? anchor(selected) : toImage(state.view.camera, viewMiddle(state)));
  return lookAt(withLens(state, { pinned: false }), place, { speaks: true });
}

/** Where the lens is in the posed picture; null until it is somewhere. */
export function posedLens(state: EditorState): Vec | null {
  const { at } = state.study.lens;
  const line = at && state.solution.shown?.deformation.posedLines(projectOf(state), [[at]], 1)[0];
  return line?.[0] ?? null;
}

/** Moves the lens by an arrow key. */
export const moveLens = (state: EditorState, by: Vec): EditorState =>
  look(state, crosshairMoved(state, by, posedLens(state) ?? undefined));

/** Asks about the shown solution, as far as the card needs it, and about the point under the lens. */
export function requestStudy(before: EditorState, emit: Emit): EditorState {
  const { shown } = before.solution;
  if (!shown || before.page.posable || !needsStudy(before)) return before;
  const { explained, page, lens } = before.study;
  if (explained?.of !== shown) return askStudy(before, shown, emit);
  const { at, asked, found } = lens;
  const known = found?.of === shown && found.at === at;
  if (page !== 'lens' || !explained.study || !at || asked || known) return before;
  emit({ type: 'find-lens', solution: shown, at });
  return withLens(before, { asked: { of: shown, at } });
}

function askStudy(state: EditorState, solution: Solution, emit: Emit): EditorState {
  if (state.study.asked === solution) return state;
  emit({ type: 'find-study', solution });
  return withStudy(state, { asked: solution });
}

/** Takes the answer about a point, and announces the newest one if the lens was moved on purpose. */
function answered(state: EditorState, { solution, at, lens }: EventOf<'lens-found'>): EditorState {
  const { explained } = state.study;
  const study = explained?.of === solution ? explained.study : null;
  const known = study ? { of: solution, at, lens, study } : null;
  const isNewest = at === state.study.lens.at;
  const speaks = state.study.lens.speaks && !isNewest;
  const next = withLens(state, { asked: null, speaks, ...(known && { found: known }) });
  if (!state.study.lens.speaks || !isNewest) return next;
  return announce(next, lens ? lensWords(lens, solution.project) : say('lens.nothingBends'));
}

/** The pages that explain the solution. */
const needsStudy = ({ study }: EditorState): boolean =>
  study.page === 'lens' || study.page === 'cells' || study.page === 'rounds';

export const lensHandlers: Handlers<
  'study-found' | 'lens-found' | 'lens-released' | 'lens-site-chosen' | 'lens-pointed'
> = {
  'study-found': (state, { solution, study }) =>
    state.study.asked === solution
      ? withStudy(state, { asked: null, explained: { of: solution, study } })
      : state,
  'lens-found': answered,
  'lens-released': (state) => withLens(state, { pinned: false }),
  'lens-site-chosen': (state, { site }) => withLens(state, { site }),
  'lens-pointed': (state, { at }) => look(state, at),
};
