/** The camera after a turn of the wheel: with Ctrl or Cmd it zooms towards the pointer, otherwise it pans. */
import { type Camera, panned, scaledAt } from '../geometry/camera';
import type { Vec } from '../geometry/vec';

/** Zoom per wheel pixel; a notch of a mouse wheel (100 to 120 px) zooms by about a fifth. */
const WHEEL_ZOOM = 0.0018;
/** Zoom per pixel of a touchpad pinch, which arrives as wheel events with Ctrl and small deltas. */
const PINCH_ZOOM = 0.01;
/** Pixels per line of a wheel that counts lines; three lines are a notch. */
const LINE_PX = 36;

export function wheeled(camera: Camera, event: WheelEvent, place: Vec): Camera {
  const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE;
  const unit = lines ? LINE_PX : 1;
  const [dx, dy] = [event.deltaX * unit, event.deltaY * unit];
  if (event.ctrlKey || event.metaKey) {
    const rate = !lines && Math.abs(dy) < 50 ? PINCH_ZOOM : WHEEL_ZOOM;
    return scaledAt(camera, camera.scale * Math.exp(-dy * rate), place);
  }
  return panned(camera, event.shiftKey && dx === 0 ? [-dy, 0] : [-dx, -dy]);
}
