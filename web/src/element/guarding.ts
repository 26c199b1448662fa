/**
 * The guard against folds: a drag, a turn, a nudge or a typed number goes only as far as it adds no folds.
 *
 * Bisects between the last allowed pose and the wanted one for the farthest pose without more folds than before. Cost:
 * one pose and one pass over all triangles for each of `STEPS`, some milliseconds in all.
 */
import type { Document } from '../document/document';
import { between } from '../document/easing';
import {
  type GroupTransform,
  interpolatedTransform,
  type PosedDocument,
  withTransform,
} from '../document/group';
import type { Project } from '../document/project';
import type { Posing } from './posing';

/** Bisections: the result is within a hundredth of the pointer's way since the last frame (2⁻⁸). */
const STEPS = 8;

export class Guarding {
  readonly #posing: Pick<Posing, 'foldsOf' | 'turns'>;
  #on = false;
  #allowed: number | null = null;
  #holding = false;
  /** How far handles have gone as one; of the same origin in all of a drag. */
  #gone: GroupTransform | null = null;

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
    this.#holding = this.#posing.foldsOf(wanted.project, allowed) > allowed;
    if (!this.#holding) {
      this.#gone = transform ?? null;
      return wanted;
    }
    const project = transform
      ? this.#transformed(wanted.project, transform, allowed)
      : this.#alone(present.project, wanted.project, allowed);
    // Equal after rounding: return the same object, so that no undo step is made.
    const same = JSON.stringify(project.handles) === JSON.stringify(present.project.handles);
    return same ? present : { ...wanted, project };
  }

  #alone(present: Project, wanted: Project, allowed: number): Project {
    const turns = this.#posing.turns();
    return this.#farthest((share) => between(present, wanted, share, turns), allowed).project;
  }

  #transformed(wanted: Project, transform: GroupTransform, allowed: number): Project {
    const { origin } = transform;
    const from = this.#gone?.origin === origin ? this.#gone : { origin, turn: 0, scale: 1 };
    const at = (share: number) => withTransform(wanted, interpolatedTransform(from, transform, share));
    const { project, share } = this.#farthest(at, allowed);
    this.#gone = interpolatedTransform(from, transform, share);
    return project;
  }

  /** The farthest allowed pose on a way that begins at 0 with an allowed one. */
  #farthest(at: (share: number) => Project, allowed: number): { project: Project; share: number } {
    let [project, share] = [at(0), 0];
    for (let step = 1; step <= STEPS; step++) {
      const tried = at(share + 0.5 ** step);
      if (this.#posing.foldsOf(tried, allowed) > allowed) continue;
      share += 0.5 ** step;
      project = tried;
    }
    return { project, share };
  }
}
