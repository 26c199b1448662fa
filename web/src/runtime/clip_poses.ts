/** The clip that poses the handles, from the WebAssembly module. */
import { type ClipPoses, createClipPoses } from '../compute/clip_poses';
import type { Playback, PosedPicture } from '../compute/posed_picture';
import { type HandlePose, handlePoses, readPoses } from '../document/handle_poses';
import type { Clip, Handle, Project } from '../document/project';

interface Asked {
  readonly clip: Clip;
  readonly handles: readonly Handle[];
  readonly poses: ClipPoses;
  playback: Playback | null;
  /** Of the project that the playback was made of. */
  stiffness: Project['stiffness'];
  /** The last time that was asked about, and the poses at it. */
  last: { readonly time: number; readonly numbers: Float64Array } | null;
}

/** Keeps the module's form of the last clip: every frame requests the same one. */
export class OpenClip {
  #asked: Asked | null = null;

  /** A clip that the module rejects does not move the handles. */
  at(clip: Clip, handles: readonly Handle[], time: number): readonly HandlePose[] {
    try {
      const asked = this.#know(clip, handles);
      const numbers = asked.poses.at(time);
      asked.last = { time, numbers };
      return readPoses(numbers);
    } catch {
      return readPoses(handlePoses(handles));
    }
  }

  /**
   * The way of a picture along the clip, and the time at which it has the pose of a project. Null if the project is not
   * in the last requested pose.
   */
  playbackOf(
    picture: PosedPicture,
    project: Project,
  ): { readonly playback: Playback; readonly time: number } | null {
    const asked = this.#asked;
    if (!asked?.last || !isSame(asked.last.numbers, handlePoses(project.handles))) return null;
    const base = { ...project, handles: asked.handles };
    if (asked.stiffness !== project.stiffness) {
      asked.playback?.free();
      asked.playback = null;
    }
    asked.stiffness = project.stiffness;
    asked.playback ??= picture.playback(asked.clip, base);
    return { playback: asked.playback, time: asked.last.time };
  }

  free(): void {
    this.#asked?.playback?.free();
    this.#asked?.poses.free();
    this.#asked = null;
  }

  #know(clip: Clip, handles: readonly Handle[]): Asked {
    if (this.#asked?.clip === clip && this.#asked.handles === handles) return this.#asked;
    this.free();
    const poses = createClipPoses(clip, handles);
    this.#asked = { clip, handles, poses, playback: null, stiffness: undefined, last: null };
    return this.#asked;
  }
}

const isSame = (a: Float64Array, b: Float64Array): boolean =>
  a.length === b.length && a.every((value, k) => Object.is(value, b[k]));
