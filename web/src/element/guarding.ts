/**
 * The guard against folds: a drag, a turn, a nudge or a number goes as far as it folds nothing, and stops there.
 *
 * Between the last pose that was allowed and the one that is wanted, the farthest one without more folds than there were
 * before is found by bisection. Cost: one pose and one look at all triangles for each of `STEPS`, some milliseconds in all.
 */
import type { Document } from '../document/document';
import { between } from '../document/easing';
import type { Turns } from '../document/handle';
import type { Project } from '../document/project';

export interface GuardingHost {
  /** How many triangles a pose turns over; counts no farther than one beyond `limit`. */
  foldsOf(project: Project, limit: number): number;
  /** How far automatic handles are turned in the pose as it is. */
  readonly turns: Turns;
}

/** Of the way that the pointer went since the last frame this leaves less than a hundredth. */
const STEPS = 8;

export class Guarding {
  readonly #host: GuardingHost;
  #on = false;
  #allowed: number | null = null;
  #holding = false;

  constructor(host: GuardingHost) {
    this.#host = host;
  }

  get on(): boolean {
    return this.#on;
  }

  set on(on: boolean) {
    this.#on = on;
    this.#holding = false;
  }

  /** Something is held back now. */
  get holding(): boolean {
    return this.#holding;
  }

  /** A drag begins at this pose: it may keep the folds that it has, and make no more. */
  begin(document: Document): void {
    this.#allowed = this.#on ? this.#host.foldsOf(document.project, Number.POSITIVE_INFINITY) : null;
  }

  /** The drag is over. */
  end(): void {
    this.#allowed = null;
    this.#holding = false;
  }

  /** How far the document may go from `present`, which is allowed, to `wanted`. */
  limited(present: Document, wanted: Document): Document {
    if (!this.#on) return wanted;
    const allowed = this.#allowed ?? this.#host.foldsOf(present.project, Number.POSITIVE_INFINITY);
    this.#holding = this.#host.foldsOf(wanted.project, allowed) > allowed;
    return this.#holding ? this.#farthest(present, wanted, allowed) : wanted;
  }

  #farthest(present: Document, wanted: Document, allowed: number): Document {
    const { turns } = this.#host;
    let [good, share] = [present.project, 0];
    for (let step = 1; step <= STEPS; step++) {
      const tried = between(present.project, wanted.project, share + 0.5 ** step, turns);
      if (this.#host.foldsOf(tried, allowed) > allowed) continue;
      share += 0.5 ** step;
      good = tried;
    }
    // Less than what a pose is rounded to: the present itself, so that no step of the history comes of it.
    const same = JSON.stringify(good.handles) === JSON.stringify(present.project.handles);
    return same ? present : { ...wanted, project: good };
  }
}
