/**
 * What is worth a word though nobody asked: folds that a pose makes, parts that it takes beyond the picture's frame, and handles that
 * lie beside the picture.
 *
 * Folds and what lies beyond take a look at the whole mesh. It is done once a drag pauses, and a few times a second while it lasts.
 */
import type { Report } from '../compute/solution';

export interface NoticingHost {
  /** How many triangles the pose as it is turns over. */
  folds(): number;
  /** Whether something of it lies beyond the picture's frame. */
  beyond(): boolean;
  /** Something else is to be shown of either. */
  changed(): void;
  /** Other handles than before have parts outside of what bends; none, where all are back. */
  outside(ids: readonly string[]): void;
}

const BREATH_MS = 200;

export class Noticing {
  readonly #host: NoticingHost;
  #folds = 0;
  #beyond = false;
  #outside = '';
  #looking: ReturnType<typeof setTimeout> | undefined;

  constructor(host: NoticingHost) {
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
