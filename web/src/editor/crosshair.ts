/** The keyboard's crosshair: arrow keys move it over the picture, Enter places a handle or a corner there. */
import { toImage, toStage } from '../geometry/camera';
import { add, scaled, type Vec } from '../geometry/vec';
import type { EditorState } from './state';
import { viewMiddle } from './view';

/** CSS pixels that an arrow key moves the crosshair for each pixel that it would nudge a handle. */
const STEP_CSS_PX = 4;

/** Where Enter places, image pixels. */
export const crosshairPlace = (state: EditorState): Vec =>
  state.display.crosshair ?? toImage(state.view.camera, viewMiddle(state));

/** Where an arrow key moves the crosshair, at most to the edge of the stage. @param start used while it is hidden. */
export function crosshairMoved(state: EditorState, by: Vec, start: Vec | undefined): Vec {
  const from = state.display.crosshair ?? start ?? crosshairPlace(state);
  const { camera } = state.view;
  const [x, y] = toStage(camera, add(from, scaled(by, STEP_CSS_PX / camera.scale)));
  const within = (value: number, most: number) => Math.min(Math.max(value, 0), most);
  return toImage(camera, [within(x, state.stage.width), within(y, state.stage.height)]);
}

export const hideCrosshair = (state: EditorState): EditorState =>
  state.display.crosshair ? { ...state, display: { ...state.display, crosshair: null } } : state;
