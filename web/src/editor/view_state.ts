/** The view of the picture: a camera, and whether the whole picture stays fitted to the stage. */
import type { Camera, Size } from '../geometry/camera';

export interface ViewState {
  readonly camera: Camera;
  /** The stage size that the camera belongs to, CSS pixels. */
  readonly stage: Size;
  /** The whole picture is kept in view until the person pans or zooms. */
  readonly fitted: boolean;
  /** The fit leaves room for the panel as a sheet. */
  readonly besideSheet: boolean;
}
