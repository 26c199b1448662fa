/**
 * How far the selected handles reach in the current pose.
 *
 * Four poses and four blends are too much for every frame of a drag: some 8 ms at 10,000 samples in the rigid mode.
 * During a drag or an animation the reach is computed a few times a second. In between, the last values move with the
 * picture.
 */

import type { Project } from '../document/project';
import type { Solution } from '../editor/solution';
import { documentOf, type EditorState } from '../editor/state';
import { isPressing } from '../tools/machine';
import type { SolutionDeformation } from './deformation';

/** Between two computations, milliseconds. */
const PAUSE_MS = 120;

export class ReachCache {
  readonly #renew: () => void;
  #solution: Solution | null = null;
  #selection: readonly string[] | null = null;
  #project: Project | null = null;
  #reach: Float32Array | null = null;
  #stale = false;
  #waiting: ReturnType<typeof setTimeout> | undefined;
  #computed = Number.NEGATIVE_INFINITY;

  /** @param renew requests another frame, since the reach is stale. */
  constructor(renew: () => void) {
    this.#renew = renew;
  }

  /** How much of a move each vertex of the solution follows; null if no selected handle is part of the solution. */
  reach(state: EditorState, deformation: SolutionDeformation): Float32Array | null {
    const { shown } = state.solution;
    const { selection, project } = documentOf(state);
    if (shown !== this.#solution || selection !== this.#selection) {
      [this.#solution, this.#selection, this.#reach] = [shown, selection, null];
      this.#compute(project, deformation);
    } else if (project !== this.#project || this.#stale) {
      const rests = !isPressing(state.tools) && performance.now() - this.#computed > PAUSE_MS;
      if (rests || this.#stale) this.#compute(project, deformation);
      else this.#waiting ??= setTimeout(() => this.#expire(), PAUSE_MS);
    }
    return this.#reach;
  }

  dispose(): void {
    clearTimeout(this.#waiting);
  }

  #expire(): void {
    this.#waiting = undefined;
    this.#stale = true;
    this.#renew();
  }

  #compute(project: Project, deformation: SolutionDeformation): void {
    clearTimeout(this.#waiting);
    this.#waiting = undefined;
    this.#stale = false;
    this.#computed = performance.now();
    this.#project = project;
    try {
      this.#reach = deformation.reach(project, this.#selection ?? []);
    } catch {
      // A pose that cannot be computed, for example of a bar without length: the last reach stays, like the picture.
    }
  }
}
