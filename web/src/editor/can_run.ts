/** Whether a command can run now, and why not: one answer for buttons, menus, keys and the element. */

import { handleById, selectedHandles } from '../document/document';
import { ringsOf } from '../document/domain';
import { CORNERS_NEEDED, DEPTHS, depthOf, isAtRest, isLine } from '../document/handle';
import { redoLabel, undoLabel } from '../document/history';
import type { Handle } from '../document/project';
import { say, type Wording } from '../texts/wording';
import { draftOf, hasTakenCorners } from '../tools/machine';
import type { CommandName } from './commands';
import { type Feature, hasFeature } from './features';
import { holdsKeys } from './keys_in_hand';
import { openClip } from './open_clip';
import { isOpaque } from './picture';
import { ringCornerInHand } from './ring_corner';
import { documentOf, type EditorState, projectOf, selectionOf } from './state';

export const canRun = (state: EditorState, command: CommandName): boolean =>
  reasonAgainst(state, command) === null;

/** Why a command cannot run now; null if it can. */
export function reasonAgainst(state: EditorState, command: CommandName): Wording | null {
  if (state.page.disabled) return say('reasons.disabled');
  return offers(state, command) ? (REASONS[command]?.(state) ?? null) : say('reasons.leftOut');
}

/** Whether the page offers a command at all. */
export const offers = ({ page }: EditorState, command: CommandName): boolean => {
  const feature = FEATURE_OF[command];
  return !feature || hasFeature(page.features, feature);
};

const FEATURE_OF: Partial<Readonly<Record<CommandName, Feature>>> = {
  select: 'tools',
  point: 'tools',
  bar: 'tools',
  polygon: 'tools',
  lasso: 'tools',
  brush: 'tools',
  hand: 'tools',
  lens: 'tools',
  suggest: 'tools',
  'turn-part': 'tools',
  'add-point': 'tools',
  timeline: 'animate',
  open: 'open',
  save: 'save',
  'save-whole': 'save',
  export: 'export',
  'export-as': 'export',
  'export-all': 'export',
  'export-whole': 'export',
};

type Reason = (state: EditorState) => Wording | null;

const unlessOpen: Reason = ({ picture }) => (picture ? null : say('reasons.noPicture'));
const unlessChangeable: Reason = ({ page }) => (page.readonly ? say('reasons.viewOnly') : null);
const withoutHandles: Reason = (state) =>
  projectOf(state).handles.length > 0 ? null : say('reasons.noHandles');

/** The first reason of several, in their order. */
const either =
  (...reasons: readonly Reason[]): Reason =>
  (state) => {
    for (const reason of reasons) {
      const found = reason(state);
      if (found !== null) return found;
    }
    return null;
  };

/** Unless some selected handle may be changed, and the change makes a difference to it. */
const unlessSelected = (differs: (handle: Handle) => boolean, otherwise: Wording): Reason =>
  either(unlessChangeable, (state) => {
    const selected = selectedHandles(documentOf(state));
    if (selected.length === 0) return say('reasons.noneSelected');
    return selected.some(differs) ? null : otherwise;
  });

const unlessAnySelected = unlessSelected(() => true, say('reasons.noneSelected'));

const unlessClipOpen: Reason = (state) => (openClip(state) ? null : say('reasons.noClipOpen'));
const unlessKeysSelected = either(unlessChangeable, (state) =>
  holdsKeys(state) ? null : say('notices.noKeysSelected'),
);

/** The bar or polygon whose corners the menu, the focus or the selection means. */
function lineInHand(state: EditorState) {
  const document = documentOf(state);
  const corner = state.menu?.corner ?? state.focus.corner;
  const [only, ...others] = selectedHandles(document);
  const line = corner ? handleById(document, corner.id) : others.length === 0 ? only : undefined;
  return line && isLine(line) ? line : null;
}

const isDrawing = ({ tools }: EditorState): boolean => draftOf(tools) !== null;

/** With the focus on a corner of the selection's outline, a command is about that one. */
const ofRing =
  (otherwise: Reason): Reason =>
  (state) =>
    ringCornerInHand(state) ? unlessChangeable(state) : otherwise(state);

/** Commands that are missing can always run. */
const REASONS: Partial<Readonly<Record<CommandName, Reason>>> = {
  select: unlessChangeable,
  point: unlessChangeable,
  bar: unlessChangeable,
  polygon: unlessChangeable,
  lasso: unlessChangeable,
  brush: unlessChangeable,
  lens: unlessOpen,
  timeline: either(unlessOpen, unlessChangeable),
  play: unlessClipOpen,
  'copy-keys': unlessKeysSelected,
  'cut-keys': unlessKeysSelected,
  'mirror-keys': unlessKeysSelected,
  'remove-keys': unlessKeysSelected,
  'select-all-keys': unlessClipOpen,
  'paste-keys': either(unlessChangeable, unlessClipOpen, ({ timeline }) =>
    timeline.copied.length > 0 ? null : say('notices.noCopiedKeys'),
  ),
  'set-key': either(
    (state) => (state.timeline.open ? null : say('reasons.noClipOpen')),
    unlessSelected(() => true, say('reasons.noneSelected')),
  ),
  open: unlessChangeable,
  save: unlessOpen,
  'save-whole': unlessOpen,
  'export-whole': unlessOpen,
  export: unlessOpen,
  'export-as': unlessOpen,
  'export-all': unlessOpen,
  compare: unlessOpen,
  preview: unlessOpen,
  settings: unlessOpen,
  undo: either(unlessOpen, unlessChangeable, (state) =>
    isDrawing(state) || undoLabel(state.document.history) !== null ? null : say('reasons.nothingToUndo'),
  ),
  redo: either(unlessOpen, unlessChangeable, (state) => {
    const can =
      hasTakenCorners(state.tools) || (!isDrawing(state) && redoLabel(state.document.history) !== null);
    return can ? null : say('reasons.nothingToRedo');
  }),
  'reset-all': either(unlessChangeable, withoutHandles, (state) =>
    projectOf(state).handles.every(isAtRest) ? say('reasons.atRest') : null,
  ),
  'select-all': either(unlessChangeable, withoutHandles),
  copy: either(unlessChangeable, withoutHandles),
  paste: either(unlessChangeable, withoutHandles),
  suggest: either(unlessOpen, unlessChangeable),
  'without-folds': either(unlessOpen, unlessChangeable, ({ checks }) =>
    checks.creases.length > 0 ? null : say('reasons.nothingFolded'),
  ),
  reset: unlessSelected((handle) => !isAtRest(handle), say('reasons.atRest')),
  mirror: unlessAnySelected,
  rename: either(unlessChangeable, (state) =>
    selectionOf(state).length === 1 ? null : say('reasons.noSingle'),
  ),
  remove: (state) => (isDrawing(state) ? null : ofRing(unlessAnySelected)(state)),
  forward: unlessSelected((handle) => depthOf(handle) !== DEPTHS.most, say('reasons.inFront')),
  backward: unlessSelected((handle) => depthOf(handle) !== DEPTHS.least, say('reasons.atBack')),
  'add-point': ({ menu }) => (menu?.bends ? null : say('reasons.nothingBends')),
  'turn-part': either(unlessOpen, unlessChangeable, (state) => {
    if (!isOpaque(state.picture)) return say('reasons.notOpaque');
    return ringsOf(projectOf(state)).length > 0 ? null : say('reasons.noLasso');
  }),
  'add-corner': ofRing(
    either(unlessChangeable, (state) => (lineInHand(state) ? null : say('reasons.noLine'))),
  ),
  'remove-corner': ofRing(
    either(unlessChangeable, (state) => {
      const line = lineInHand(state);
      if (!line) return say('reasons.noLine');
      const needed = CORNERS_NEEDED[line.kind];
      return line.posed.length > needed ? null : say(`reasons.cornersNeeded.${line.kind}`, needed);
    }),
  ),
};
