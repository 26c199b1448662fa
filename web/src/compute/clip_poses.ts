/** Handles along a clip, by the module that also draws and exports: the editor shows the same poses. */
import type { Clip, Handle } from '../document/project';
import { createModuleClip } from './module';

/** The poses of some handles along a clip. Holds memory of the module until {@link ClipPoses.free}. */
export interface ClipPoses {
  /**
   * The poses at any time in seconds, in the order of the handles; the clip's `loop` says what follows its end. Takes
   * microseconds. The layout is that of `document/handle_poses`.
   */
  at(time: number): Float64Array<ArrayBuffer>;

  /** Releases the module's memory. No query may follow. */
  free(): void;
}

/**
 * Requires the module to be loaded. Handles without a track keep their pose.
 * @throws C2WarpError for a clip that does not fit the handles, with the path of the offending key.
 */
export const createClipPoses = (clip: Clip, handles: readonly Handle[]): ClipPoses =>
  createModuleClip(clip, handles);
