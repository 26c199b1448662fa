/** The corners of the selection's outline, by keys and double clicks: moving, adding and removing them. */

import { ringsOf } from '../../document/domain';
import {
  type RingCorner,
  ringCornerAt,
  withRingCornerAdded,
  withRingCornerMoved,
  withRingCornerRemoved,
} from '../../document/lasso_corners';
import type { Project } from '../../document/project';
import { add, type Vec } from '../../geometry/vec';
import { say, type Wording } from '../../texts/wording';
import { draftOf } from '../../tools/machine';
import { ringHit } from '../../tools/ring_hit';
import type { Emit } from '../effects';
import { gripsOf } from '../hit_areas';
import { ringCornerInHand } from '../ring_corner';
import { documentOf, type EditorState, projectOf } from '../state';
import { announce, informOfStep } from './notices';
import { commitStep } from './steps';

const focusRing = (emit: Emit, ring: RingCorner): void =>
  emit({ type: 'focus', target: { handle: null, corner: null, ring } });

/** Where a corner is, for screen readers. */
function words(project: Project, corner: RingCorner): Wording {
  const [x = 0, y = 0] = ringCornerAt(project, corner)?.map(Math.round) ?? [];
  return say('spoken.selectionCornerAt', corner.index + 1, x, y);
}

/** @param key moves of one corner are one undo step. */
function stepped(
  state: EditorState,
  label: Wording,
  project: Project,
  corner: RingCorner,
  emit: Emit,
  key: string | null = null,
): EditorState {
  const gone = projectOf(state).handles.length - project.handles.length;
  const next = announce(
    commitStep(state, label, { ...documentOf(state), project }, emit, key),
    words(project, corner),
  );
  return gone > 0 ? informOfStep(next, say('notices.leftOut', gone), emit) : next;
}

export function nudgeRingCorner(state: EditorState, by: Vec, emit: Emit): EditorState {
  const corner = ringCornerInHand(state);
  const at = corner && ringCornerAt(projectOf(state), corner);
  if (!corner || !at) return state;
  const project = withRingCornerMoved(projectOf(state), corner, add(at, by));
  if (!project) return announce(state, say('spoken.cornerCrosses'));
  const key = `nudge ring ${corner.ring} ${corner.index}`;
  return stepped(state, say('steps.moveSelectionCorner'), project, corner, emit, key);
}

/** Adds a corner halfway after the focused one. */
export function addRingCorner(state: EditorState, emit: Emit): EditorState {
  const corner = ringCornerInHand(state);
  if (!corner) return state;
  const project = withRingCornerAdded(projectOf(state), corner.ring, { edge: corner.index, fraction: 0.5 });
  const added = { ...corner, index: corner.index + 1 };
  focusRing(emit, added);
  return stepped(state, say('steps.addSelectionCorner'), project, added, emit);
}

export function removeRingCorner(state: EditorState, emit: Emit): EditorState {
  const corner = ringCornerInHand(state);
  return corner ? removed(state, corner, emit) : state;
}

/** Removes the corner under a double click of the lasso. */
export function removeRingCornerAt(state: EditorState, at: Vec, emit: Emit): EditorState {
  const hit = draftOf(state.tools) ? null : ringHit(projectOf(state), gripsOf(state), at);
  return hit?.part === 'corner' ? removed(state, hit, emit) : state;
}

function removed(state: EditorState, { ring, index }: RingCorner, emit: Emit): EditorState {
  const project = withRingCornerRemoved(projectOf(state), { ring, index });
  if (!project) return announce(state, say('spoken.cornerStays'));
  const count = ringsOf(project)[ring]?.length ?? 1;
  const before = { ring, index: (index - 1 + count) % count };
  focusRing(emit, before);
  return stepped(state, say('steps.deleteSelectionCorner'), project, before, emit);
}
