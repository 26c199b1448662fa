/** The poses of the clip that is open, from the WebAssembly module. */
import { type ClipPoses, createClipPoses } from '../compute/clip_poses';
import { type HandlePose, handlePoses, readPoses } from '../document/handle_poses';
import type { Clip, Handle } from '../document/project';

/** Keeps the module's form of the last clip: frame after frame asks for the same one. */
export class OpenClip {
  #asked: { readonly clip: Clip; readonly handles: readonly Handle[]; readonly poses: ClipPoses } | null =
    null;

  /** A clip that the module refuses leaves the handles as they are. */
  at(clip: Clip, handles: readonly Handle[], time: number): readonly HandlePose[] {
    try {
      return readPoses(this.#posesOf(clip, handles).at(time));
    } catch {
      return readPoses(handlePoses(handles));
    }
  }

  free(): void {
    this.#asked?.poses.free();
    this.#asked = null;
  }

  #posesOf(clip: Clip, handles: readonly Handle[]): ClipPoses {
    if (this.#asked?.clip !== clip || this.#asked.handles !== handles) {
      this.free();
      this.#asked = { clip, handles, poses: createClipPoses(clip, handles) };
    }
    return this.#asked.poses;
  }
}
