/** The way of the picture from the last frame of a drag to the pose in which it rests. */
import type { Pose } from '../compute/posed_picture';

/** What is drawn of a pose. */
export type DrawnPose = Pick<Pose, 'motions' | 'places' | 'project' | 'triangles' | 'crossed'>;

const GLIDE_MS = 240;

/** Eases out: the picture comes to rest, and does not stop suddenly. */
const eased = (share: number): number => 1 - (1 - share) ** 3;

export class Glide {
  #way: { readonly from: Float32Array; readonly to: Pose; readonly start: number } | null = null;

  /** Begins at the pose that is drawn at this time. */
  begin(from: DrawnPose, to: Pose, now: number): void {
    const { motions } = this.at(from, now);
    this.#way = motions.length === to.motions.length ? { from: motions, to, start: now } : null;
  }

  /** The pose to draw at this time. While the picture glides to a pose, that is an interpolated one. */
  at(pose: DrawnPose, now: number): DrawnPose {
    const way = this.#way;
    if (!way || way.to !== pose || now - way.start >= GLIDE_MS) {
      this.#way = null;
      return pose;
    }
    const share = eased(Math.max(0, now - way.start) / GLIDE_MS);
    const motions = way.to.motions.map((to, k) => {
      const from = way.from[k] ?? to;
      return from + share * (to - from);
    });
    const { places, project, triangles } = pose;
    return { motions, places, project, triangles, crossed: () => pose.crossed() };
  }

  get gliding(): boolean {
    return this.#way !== null;
  }
}
