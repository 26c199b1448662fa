/**
 * Changes of the view. Until the person pans or zooms, the whole picture stays fitted to the stage. That is its own
 * rectangle, which is exported, and the parts that are bent beyond it.
 */
import { type Box, boxOfBoth, reachesBeyond } from '../geometry/box';
import {
  type Camera,
  fitted,
  type Insets,
  keptInView,
  panned,
  type Size,
  scaledAt,
  toImage,
  toStage,
} from '../geometry/camera';
import { add, midpoint, subtract, type Vec } from '../geometry/vec';
import type { ExportChoices } from './export_choices';
import { insetsOf } from './insets';
import { PHONE } from './sizes';
import { type EditorState, projectOf, selectionOf } from './state';
import type { Sheet, ViewState } from './view_state';

/** Image pixels beyond the frame that may be due to rounding. */
const SLACK = 0.5;

/** Half of the least side of a box that the view zooms to, image pixels. */
const LEAST_HALF_SHOWN = 40;

/** Zoom factor of one step of the zoom buttons. */
const NOTCH = Math.SQRT2;

/** Bounding box of the posed picture, image pixels; null before the first solution. */
export const posedBounds = (state: EditorState): Box | null =>
  state.solution.shown?.deformation.bounds(projectOf(state)) ?? null;

/** Whether part of the posed picture lies outside the picture's own rectangle. */
export function reachesBeyondFrame(state: EditorState): boolean {
  const bounds = posedBounds(state);
  return bounds !== null && state.picture !== null && reachesBeyond(bounds, frameOf(state), SLACK);
}

/** The size of an exported picture, in pixels. */
export function exportSize(
  state: EditorState,
  { percent, area }: Pick<ExportChoices, 'percent' | 'area'>,
): Size | null {
  if (!state.picture) return null;
  const posed = posedBounds(state) ?? frameOf(state);
  const whole = { picture: frameOf(state), grown: boxOfBoth(frameOf(state), posed), covered: posed };
  const { min, max } = whole[area];
  const [width, height] = subtract(max, min).map((side) => Math.round((side * percent) / 100));
  return { width: Math.max(1, width ?? 1), height: Math.max(1, height ?? 1) };
}

/** @param view an earlier view to restore; without it the whole picture is fitted. */
export function openView(state: EditorState, view?: ViewState): EditorState {
  if (!view) return fitView(state);
  return resize({ ...state, view }, state.view.stage);
}

/**
 * Adapts to another size of the stage. Ignores a hidden stage, which has no size.
 *
 * @param still keeps the picture where it is: an on-screen keyboard or a press must not move it.
 */
export function resize(state: EditorState, stage: Size, still = false): EditorState {
  if (!(stage.width > 0 && stage.height > 0)) return state;
  const sized = { ...state, stage };
  if (still) return sized;
  const { camera, stage: before } = state.view;
  const by: Vec = [(stage.width - before.width) / 2, (stage.height - before.height) / 2];
  return refitView({ ...sized, view: { ...state.view, stage, camera: panned(camera, by) } });
}

/** Moves the camera for the person, while some of the picture is in view. The picture is no longer kept fitted. */
export const moveCamera = (state: EditorState, camera: Camera): EditorState =>
  withCamera(
    state,
    state.picture ? keptInView(camera, drawnBounds(state), state.stage, insets(state)) : camera,
  );

const withCamera = (state: EditorState, camera: Camera): EditorState => ({
  ...state,
  view: { ...state.view, camera, fitted: false },
});

/** Bounding box of everything drawn: the posed picture and, unless its outline bounds it, the picture around it. */
function drawnBounds(state: EditorState): Box {
  const posed = posedBounds(state);
  if (posed && projectOf(state).domain?.kind === 'alpha') return posed;
  return posed ? boxOfBoth(frameOf(state), posed) : frameOf(state);
}

/** @param sheet the sheet to leave room for. */
export function fitView(state: EditorState, sheet = openSheet(state)): EditorState {
  const view = { ...state.view, fitted: true, sheet };
  if (!state.picture) return { ...state, view };
  const posed = posedBounds(state);
  const all = posed ? boxOfBoth(frameOf(state), posed) : frameOf(state);
  const camera = fitted(all, state.stage, insets(state, sheet));
  return { ...state, view: { ...view, camera } };
}

/**
 * Fits again unless the person has panned or zoomed. Makes room for settings, which somebody has opened. A sheet of one
 * line does not move the picture, because a press has opened it.
 */
export function refitView(state: EditorState): EditorState {
  if (!state.view.fitted) return state;
  const [open, before] = [openSheet(state), state.view.sheet];
  return fitView(state, open === 'tall' || before === 'tall' ? open : before);
}

/** Whether the layout has the panel as a sheet, which shows one thing at a time. */
export const hasSheet = ({ stage }: EditorState): boolean => stage.width < PHONE;

/** @param scale CSS pixels per image pixel, within the limits of the camera. */
export const zoomTo = (state: EditorState, scale: number): EditorState =>
  moveCamera(state, scaledAt(state.view.camera, scale, viewMiddle(state)));

/** Zooms to 100 %: one image pixel for one CSS pixel. */
export const showActualSize = (state: EditorState): EditorState => zoomTo(state, 1);

export const zoom = (state: EditorState, notches: number): EditorState =>
  zoomTo(state, state.view.camera.scale * NOTCH ** notches);

/** Zooms to a box of the picture with as much again around it. */
export function showBox(state: EditorState, { min, max }: Box): EditorState {
  const centre = midpoint(min, max);
  const half = Math.max(LEAST_HALF_SHOWN, max[0] - min[0], max[1] - min[1]);
  const around: Box = { min: subtract(centre, [half, half]), max: add(centre, [half, half]) };
  return moveCamera(state, fitted(around, state.stage, insets(state)));
}

/** Pans by the shortest way until no card covers a point of the picture. */
export function reveal(state: EditorState, at: Vec): EditorState {
  const [x, y] = outsideBy(state, at);
  return x === 0 && y === 0 ? state : withCamera(state, panned(state.view.camera, [-x, -y]));
}

/**
 * For a page that plays, where nobody can pan or zoom. Fits the whole posed picture once one of these points is out of
 * view. Restores its size once no part is bent beyond the frame.
 */
export function contain(state: EditorState, places: readonly Vec[]): EditorState {
  if (!state.widened && places.every((at) => isInView(state, at))) return state;
  const next = fitView(state);
  return { ...next, widened: reachesBeyondFrame(next) };
}

/** Whether no card covers a point of the picture. */
export const isInView = (state: EditorState, at: Vec): boolean =>
  outsideBy(state, at).every((by) => Math.abs(by) < 1);

/** The area free of cards, CSS pixels of the stage. */
export function freeStage(state: EditorState): Box {
  const { top, right, bottom, left } = insets(state);
  const { width, height } = state.stage;
  return { min: [left, top], max: [width - right, height - bottom] };
}

/** The area free of cards, image pixels. */
export function freeArea(state: EditorState): Box {
  const { min, max } = freeStage(state);
  return { min: toImage(state.view.camera, min), max: toImage(state.view.camera, max) };
}

/** The middle of the area free of cards, CSS pixels. */
export function viewMiddle(state: EditorState): Vec {
  const { top, right, bottom, left } = insets(state);
  return [(left + state.stage.width - right) / 2, (top + state.stage.height - bottom) / 2];
}

/** How far a point lies outside the area free of cards, CSS pixels. */
function outsideBy(state: EditorState, at: Vec): Vec {
  const { min, max } = freeStage(state);
  const [x, y] = toStage(state.view.camera, at);
  return [beyond(x, min[0], max[0]), beyond(y, min[1], max[1])];
}

const beyond = (at: number, least: number, most: number): number => at - Math.max(least, Math.min(at, most));

const frameOf = ({ picture }: EditorState): Box => ({
  min: [0, 0],
  max: [picture?.width ?? 0, picture?.height ?? 0],
});

function openSheet(state: EditorState): Sheet {
  const { settings, overlayList } = state.display;
  return settings || overlayList ? 'tall' : selectionOf(state).length > 0 ? 'line' : 'none';
}

export function insets(state: EditorState, sheet = openSheet(state)): Insets {
  const { posable, readonly } = state.page;
  const bare = posable ? (readonly ? 'picture' : 'handles') : null;
  const study = state.study.page;
  const timeline = state.timeline.open && !posable;
  const { coarse, rtl } = state.media;
  const { left, right, ...others } = insetsOf({ stage: state.stage, coarse, sheet, study, timeline, bare });
  // The cards change sides.
  return rtl ? { ...others, left: right, right: left } : { ...others, left, right };
}
