/** The view of the picture: a camera, and whether the whole picture stays fitted to the stage. */
import type { Camera, Size } from '../geometry/camera';

export interface ViewState {
  readonly camera: Camera;
  /** The stage size that the camera belongs to, CSS pixels. */
  readonly stage: Size;
  /** The whole picture is kept in view until the person pans or zooms. */
  readonly fitted: boolean;
  /** The sheet that the fit leaves room for. */
  readonly sheet: Sheet;
}

/** The panel as a sheet: closed, one line about the selected handles, or settings of the whole picture. */
export type Sheet = 'none' | 'line' | 'tall';
