/**
 * What is worth a word though nobody asked: folds that a pose makes, and handles that lie beside the picture.
 *
 * Counting folds takes a look at every triangle. It is done once a drag pauses, and a few times a second while it lasts.
 */
import type { Report } from '../compute/solution';

export interface NoticingHost {
  /** How many triangles the pose as it is turns over. */
  folds(): number;
  /** Another count is to be shown. */
  changed(): void;
  /** Other handles than before have parts outside of what bends; none, where all are back. */
  outside(ids: readonly string[]): void;
}

const BREATH_MS = 200;

export class Noticing {
  readonly #host: NoticingHost;
  #folds = 0;
  #outside = '';
  #counting: ReturnType<typeof setTimeout> | undefined;

  constructor(host: NoticingHost) {
    this.#host = host;
  }

  /** As of the last count. */
  get folds(): number {
    return this.#folds;
  }

  posed(): void {
    this.#counting ??= setTimeout(() => this.#count(), BREATH_MS);
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
    clearTimeout(this.#counting);
  }

  #count(): void {
    this.#counting = undefined;
    const folds = this.#host.folds();
    if (folds === this.#folds) return;
    this.#folds = folds;
    this.#host.changed();
  }
}
