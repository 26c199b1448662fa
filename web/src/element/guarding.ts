/**
 * The guard against folds: a drag, a turn, a nudge or a typed number goes only as far as it adds no folds.
 *
 * Bisects between the last allowed pose and the wanted one for the farthest pose without more folds than before. Cost:
 * one pose and one pass over all triangles for each of `STEPS`, some milliseconds in all.
 */
import type { Document } from '../document/document';
import { between } from '../document/easing';
import type { Vec } from '../geometry/vec';
import type { Posing } from './posing';

/** Bisections: the result is within a hundredth of the pointer's way since the last frame (2⁻⁸). */
const STEPS = 8;

export class Guarding {
  readonly #posing: Pick<Posing, 'foldsOf' | 'turns'>;
  #on = false;
  #allowed: number | null = null;
  #holding = false;

  constructor(posing: Pick<Posing, 'foldsOf' | 'turns'>) {
    this.#posing = posing;
  }

  get on(): boolean {
    return this.#on;
  }

  set on(on: boolean) {
    this.#on = on;
    this.#holding = false;
  }

  /** Whether the last change was limited. */
  get holding(): boolean {
    return this.#holding;
  }

  /** Starts a drag: the folds of this pose are allowed, but no more. */
  begin(document: Document): void {
    this.#allowed = this.#on ? this.#posing.foldsOf(document.project, Number.POSITIVE_INFINITY) : null;
  }

  /** Ends a drag. */
  end(): void {
    this.#allowed = null;
    this.#holding = false;
  }

  /**
   * The document as far as allowed on the way from `present`, which is allowed, to `wanted`.
   * @param about where handles are turned and scaled as one: on the way they stay one.
   */
  limited(present: Document, wanted: Document, about?: Vec): Document {
    if (!this.#on) return wanted;
    const allowed = this.#allowed ?? this.#posing.foldsOf(present.project, Number.POSITIVE_INFINITY);
    this.#holding = this.#posing.foldsOf(wanted.project, allowed) > allowed;
    return this.#holding ? this.#farthest(present, wanted, allowed, about) : wanted;
  }

  #farthest(present: Document, wanted: Document, allowed: number, about?: Vec): Document {
    const turns = this.#posing.turns();
    let [good, share] = [present.project, 0];
    for (let step = 1; step <= STEPS; step++) {
      const tried = between(present.project, wanted.project, share + 0.5 ** step, turns, about);
      if (this.#posing.foldsOf(tried, allowed) > allowed) continue;
      share += 0.5 ** step;
      good = tried;
    }
    // Equal after rounding: return the same object, so that no undo step is made.
    const same = JSON.stringify(good.handles) === JSON.stringify(present.project.handles);
    return same ? present : { ...wanted, project: good };
  }
}
