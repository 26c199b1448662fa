/**
 * Watches for what a person may overlook: folds, parts of the picture outside its frame, and handles partly outside the
 * picture.
 *
 * Folds and the frame need a pass over the whole mesh, made a few times a second during a drag and once after it.
 */
import type { Report } from '../compute/solution';

export interface PoseChecksHost {
  /** Whether what is found is shown. */
  readonly shown: boolean;
  /** The number of triangles that the current pose turns over. */
  folds(): number;
  /** Whether part of the posed picture lies outside the picture's frame. */
  beyond(): boolean;
  /** One of these two has changed. */
  changed(): void;
  /** The parts of handles outside the bending area have changed, and there are some. */
  outside(ids: readonly string[]): void;
}

const BREATH_MS = 200;

export class PoseChecks {
  readonly #host: PoseChecksHost;
  #folds = 0;
  #beyond = false;
  #outside = '';
  #looking: ReturnType<typeof setTimeout> | undefined;

  constructor(host: PoseChecksHost) {
    this.#host = host;
  }

  /** As of the last look. */
  get folds(): number {
    return this.#folds;
  }

  /** As of the last look. */
  get beyond(): boolean {
    return this.#beyond;
  }

  posed(): void {
    if (!this.#host.shown) return;
    this.#looking ??= setTimeout(() => this.#look(), BREATH_MS);
  }

  solved(report: Report): void {
    this.posed();
    const ids = [...new Set((report.outside ?? []).map(({ handle }) => handle))];
    const outside = JSON.stringify(report.outside ?? []);
    if (outside === this.#outside) return;
    this.#outside = outside;
    if (ids.length > 0) this.#host.outside(ids);
  }

  dispose(): void {
    clearTimeout(this.#looking);
  }

  #look(): void {
    this.#looking = undefined;
    const [folds, beyond] = [this.#host.folds(), this.#host.beyond()];
    if (folds === this.#folds && beyond === this.#beyond) return;
    [this.#folds, this.#beyond] = [folds, beyond];
    this.#host.changed();
  }
}
