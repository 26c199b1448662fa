/** The hit areas of a press, as large as the pointer in use needs, and the context in which tools find them. */

import { isSameDomain, ringsOf } from '../document/domain';
import type { HiddenCorners, Turns } from '../document/handle';
import { toImage } from '../geometry/camera';
import { distanceToLine } from '../geometry/polyline';
import { isInsideOf } from '../geometry/ring';
import type { ToolBrush } from '../tools/brush_kinds';
import { type Hit, hit } from '../tools/hit';
import type { Grips, Press, ToolContext } from '../tools/state';
import { sizeOf } from './brush_state';
import { traceOf } from './edge_snapping';
import { handlesAreShown } from './permissions';
import { snapped } from './snapping';
import type { StagePointer } from './stage_pointer';
import { documentOf, type EditorState, projectOf } from './state';
import { freeArea } from './view';

/** Sizes of the hit areas for a mouse and for a finger, CSS pixels. See `Grips`. */
const SIZES = {
  fine: { handle: 14, line: 9, ring: 40, band: 8, slop: 3 },
  coarse: { handle: 24, line: 20, ring: 52, band: 18, slop: 8 },
} as const;

/** The sizes now, image pixels. */
export function gripsOf(state: EditorState): Grips {
  const { handle, line, ring, band, slop } = state.pointer.coarse ? SIZES.coarse : SIZES.fine;
  const { scale } = state.view.camera;
  return {
    handle: handle / scale,
    line: line / scale,
    ring: ring / scale,
    band: band / scale,
    slop: slop / scale,
    view: freeArea(state),
  };
}

export function toolContext(state: EditorState): ToolContext {
  const grips = gripsOf(state);
  const project = projectOf(state);
  const deformation = state.solution.shown?.deformation;
  return {
    document: documentOf(state),
    grips,
    get turns() {
      return turnsOf(state);
    },
    posesOnly: state.page.posable,
    get brush() {
      return brushOf(state);
    },
    guards: state.guard.on,
    heldOutline: () => (project.fix_boundary ? (deformation?.restOutline() ?? null) : null),
    get trace() {
      return traceOf(state);
    },
    snap: (at, moving) => snapped(state, at, moving),
    place: (at, within = grips.line) => {
      if (isLeftOut(state, at, within)) return null;
      if (deformation) return deformation.placement(project, at, within);
      // Without a solution, the point of the original is the place itself.
      return isOnPicture(state, at) ? { posed: at, rest: at, rotation: 0, scale: 1 } : null;
    },
    layerUnder: (corners) =>
      deformation?.layerUnder(project, corners) ?? corners.map((rest) => ({ rest, rotation: 0, scale: 1 })),
  };
}

/** The context without hit areas: a press places something, even on an existing handle. */
export function contextWithoutHandles(state: EditorState): ToolContext {
  const context = toolContext(state);
  return { ...context, grips: { ...context.grips, handle: -1, line: -1, band: -1 } };
}

/** The turns of automatic handles; empty before the first solution. */
export const turnsOf = (state: EditorState): Turns =>
  state.solution.shown?.deformation.turns(projectOf(state)) ?? NO_TURNS;

const NO_TURNS: Turns = new Map();

/** The corners of handles that lie behind another part; empty before the first solution. */
export const hiddenOf = (state: EditorState): HiddenCorners =>
  state.solution.shown?.deformation.hidden(projectOf(state)) ?? NOTHING_HIDDEN;

const NOTHING_HIDDEN: HiddenCorners = new Map();

export const isBrushing = ({ tools }: EditorState): boolean => tools.tool === 'brush';

/** Whether the brush is in hand that paints stiffness. */
export const isStiffening = (state: EditorState): boolean =>
  isBrushing(state) && state.brush.kind === 'stiffen';

/** The brush in pixels of the picture. */
export function brushOf(state: EditorState): ToolBrush {
  const { kind, strength, erases } = state.brush;
  const { width, height } = projectOf(state).image;
  const radius = (sizeOf(state.brush) / 200) * Math.max(width, height);
  return { kind, radius, strength: strength / 100, erases };
}

export const isLassoing = ({ tools }: EditorState): boolean => tools.tool === 'lasso';

/**
 * The part of a handle at a place; null while a lasso covers the handles, the brush paints over them, or the lens looks
 * through them.
 */
export const hitAt = (
  state: EditorState,
  at: Press['at'],
  bodies = true,
  context = toolContext(state),
  alt = false,
): Hit | null =>
  isLassoing(state) || isBrushing(state) || state.tools.tool === 'lens'
    ? null
    : hit(context, at, bodies, alt);

export function pressOf(state: EditorState, { stage, shift, alt, free }: StagePointer): Press {
  return { at: toImage(state.view.camera, stage), stage, shift, alt, free };
}

/** Whether a press there would hold a handle. */
export const holdsAt = (state: EditorState, pointer: StagePointer): boolean => {
  const noted = { ...state, pointer: { ...state.pointer, coarse: pointer.coarse } };
  return handlesAreShown(noted) && hitAt(noted, pressOf(noted, pointer).at) !== null;
};

/** Whether a place lies outside of a selection that is not solved yet. The shown solution still has another one. */
function isLeftOut(state: EditorState, at: Press['at'], within: number): boolean {
  const project = projectOf(state);
  const rings = ringsOf(project);
  const { shown } = state.solution;
  if (rings.length === 0 || (shown && isSameDomain(shown.project, project))) return false;
  return !isInsideOf(rings, at) && rings.every((ring) => distanceToLine(ring, true, at) > within);
}

function isOnPicture({ picture }: EditorState, [x, y]: Press['at']): boolean {
  return picture !== null && x >= 0 && y >= 0 && x < picture.width && y < picture.height;
}
