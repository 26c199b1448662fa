/**
 * The guard against folds: a drag, a turn, a nudge or a typed number goes only as far as it adds no folds.
 *
 * The solver bisects between the last allowed pose and the wanted one. Cost: some milliseconds.
 */
import type { LimitedPose } from '../compute/posed_picture';
import type { Document } from '../document/document';
import { type GroupTransform, interpolatedTransform, type PosedDocument } from '../document/group';
import type { Posing } from './posing';

type Folds = Pick<Posing, 'foldsOf' | 'foldLimit' | 'groupFoldLimit'>;

export class Guarding {
  readonly #posing: Folds;
  #on = false;
  #allowed: number | null = null;
  #holding = false;
  /** How far handles have gone as one; of the same origin in all of a drag. */
  #gone: GroupTransform | null = null;

  constructor(posing: Folds) {
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
    this.#gone = null;
  }

  /** Ends a drag. */
  end(): void {
    this.#allowed = null;
    this.#holding = false;
    this.#gone = null;
  }

  /**
   * The document as far as allowed on the way from `present`, which is allowed, to the wanted one. What is turned and scaled
   * as one stays so on the way.
   */
  limited(present: Document, { document: wanted, transform }: PosedDocument): Document {
    if (!this.#on) return wanted;
    const allowed = this.#allowed ?? this.#posing.foldsOf(present.project, Number.POSITIVE_INFINITY);
    const { project, fraction } = transform
      ? this.#transformed(wanted, transform, allowed)
      : this.#posing.foldLimit(present.project, wanted.project, allowed);
    this.#holding = fraction < 1;
    if (!this.#holding) {
      this.#gone = transform ?? null;
      return wanted;
    }
    // Equal after rounding: return the same object, so that no undo step is made.
    const same = JSON.stringify(project.handles) === JSON.stringify(present.project.handles);
    return same ? present : { ...wanted, project };
  }

  #transformed({ project: to }: Document, end: GroupTransform, allowed: number): LimitedPose {
    const { origin } = end;
    const start = this.#gone?.origin === origin ? this.#gone : { origin, turn: 0, scale: 1 };
    const { project, selection } = origin;
    const limit = this.#posing.groupFoldLimit({ origin: project, selection, to, start, end }, allowed);
    this.#gone = interpolatedTransform(start, end, limit.fraction);
    return limit;
  }
}
