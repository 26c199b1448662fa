/**
 * How far the selected handles reach in the current pose.
 *
 * Four poses and four blends are too much for every frame of a drag: some 8 ms at 10,000 samples in the rigid mode.
 * During a drag or an animation the reach is computed a few times a second; in between, the last values move with the
 * picture.
 */
import type { Project } from '../document/project';
import type { Solved } from './solving';
import type { Workbench } from './workbench';

export interface ReachingHost {
  readonly workbench: Workbench;
  /** The reach has changed: draw again. */
  changed(): void;
}

/** Between two computations, milliseconds. */
const PAUSE_MS = 120;

export class Reaching {
  readonly #host: ReachingHost;
  #solved: Solved | null = null;
  #selection: readonly string[] | null = null;
  #project: Project | null = null;
  #reach: Float32Array | null = null;
  #waiting: ReturnType<typeof setTimeout> | undefined;
  #renewed = Number.NEGATIVE_INFINITY;

  constructor(host: ReachingHost) {
    this.#host = host;
  }

  /** How much of a move each vertex of the solution follows; null if no selected handle is part of the solution. */
  reach(): Float32Array | null {
    const { editing, solving } = this.#host.workbench;
    const { selection, project } = editing.document;
    if (solving.current !== this.#solved || selection !== this.#selection) {
      [this.#solved, this.#selection, this.#reach] = [solving.current, selection, null];
      this.#renew();
    } else if (project !== this.#project) {
      const rests = !editing.machine.busy && performance.now() - this.#renewed > PAUSE_MS;
      if (!rests) this.#waiting ??= setTimeout(() => this.#again(), PAUSE_MS);
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
    this.#renewed = performance.now();
    const { editing } = this.#host.workbench;
    const { selection, project } = editing.document;
    this.#project = project;
    if (!this.#solved) return;
    try {
      this.#reach = this.#solved.posed.reach(project, selection) ?? this.#reach;
    } catch {
      // The solver cannot pose this, for example a bar of no length: the last reach stays, like the picture.
    }
  }
}
