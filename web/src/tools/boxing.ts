/** Dragging a box over empty space selects the handles inside. Shift adds them to the selection. */

import { anchor, corners } from '../document/handle';
import type { Project } from '../document/project';
import { type Box, boxBetween, boxContains } from '../geometry/box';
import type { Vec } from '../geometry/vec';
import { outcome, type State } from './state';

/** A bar or polygon is inside if its middle or one of its corners is. */
const idsWithin = (project: Project, box: Box): readonly string[] =>
  project.handles
    .filter((handle) => [anchor(handle), ...corners(handle)].some((p) => boxContains(box, p)))
    .map((handle) => handle.id);

export const boxing = (before: readonly string[], from: Vec, shift: boolean, rest: State): State => {
  const kept = shift ? before : [];
  const state: State = {
    move: (press, { document }) => {
      const box = boxBetween(from, press.at);
      const ids = [...kept, ...idsWithin(document.project, box)];
      return outcome(state, { type: 'box', box }, { type: 'select', ids });
    },
    up: () => outcome(rest, { type: 'box', box: null }),
    cancel: () => outcome(rest, { type: 'box', box: null }, { type: 'select', ids: before }),
  };
  return state;
};
