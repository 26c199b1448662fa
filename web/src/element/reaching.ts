/**
 * How far the selected handles reach in the pose as it is.
 *
 * Four poses and four blends are too much for every frame of a drag: some 8 ms at 10,000 samples in the rigid mode. While one goes on
 * it is found anew some times a second; in between, what was found before goes along with the picture.
 */
import { blendOf } from '../document/bending';
import { displaced } from '../document/handle';
import type { Project } from '../document/project';
import { type MovedMotions, REACH_STEP, reachOf } from '../geometry/reach';
import type { Vec } from '../geometry/vec';
import type { Solved } from './solving';
import type { Workbench } from './workbench';

export interface ReachingHost {
  readonly workbench: Workbench;
  /** It is to be drawn anew. */
  changed(): void;
}

/** In a drag, from one time to the next. */
const PAUSE_MS = 120;

export class Reaching {
  readonly #host: ReachingHost;
  #solved: Solved | null = null;
  #selection: readonly string[] | null = null;
  #project: Project | null = null;
  #reach: Float32Array | null = null;
  #waiting: ReturnType<typeof setTimeout> | undefined;

  constructor(host: ReachingHost) {
    this.#host = host;
  }

  /** Vertices of the solution shown: how much of a move each follows. Null where nothing is selected that the solution knows. */
  reach(): Float32Array | null {
    const { editing, solving } = this.#host.workbench;
    const { selection, project } = editing.document;
    if (solving.current !== this.#solved || selection !== this.#selection) {
      [this.#solved, this.#selection, this.#reach] = [solving.current, selection, null];
      this.#renew();
    } else if (project !== this.#project) {
      if (editing.machine.busy) this.#waiting ??= setTimeout(() => this.#again(), PAUSE_MS);
      else this.#renew();
    }
    return this.#reach;
  }

  dispose(): void {
    clearTimeout(this.#waiting);
  }

  #again(): void {
    this.#renew();
    this.#host.changed();
  }

  #renew(): void {
    clearTimeout(this.#waiting);
    this.#waiting = undefined;
    const { editing, picture } = this.#host.workbench;
    const { selection, project } = editing.document;
    this.#project = project;
    const data = this.#solved?.data;
    const known = this.#solved?.project.handles.some(({ id }) => selection.includes(id));
    if (!data || !picture || !known) return;
    const step = REACH_STEP * Math.hypot(picture.width, picture.height);
    const steps: readonly Vec[] = [
      [step, 0],
      [-step, 0],
      [0, step],
      [0, -step],
    ];
    try {
      const moved = steps.map((by) => this.#moved(by)) as readonly (Float32Array | null)[];
      this.#reach = reachOf(data, moved as MovedMotions, step, blendOf(project));
    } catch {
      // No pose at all, such as a bar drawn together to one spot: the picture is left as it was, and so is this.
    }
  }

  /** Motions with everything selected moved. */
  #moved(by: Vec): Float32Array | null {
    const { editing, solving } = this.#host.workbench;
    const { selection, project } = editing.document;
    const handles = project.handles.map((handle) =>
      selection.includes(handle.id) ? displaced(handle, by) : handle,
    );
    return solving.motions({ ...project, handles });
  }
}
