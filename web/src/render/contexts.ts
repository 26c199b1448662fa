/**
 * Decides which drawings of a page hold a WebGL context. Browsers allow a page about 16, and take the oldest away for
 * a new one, visible or not; here the drawings that have been out of sight longest release theirs before that.
 */

export interface Drawn {
  /** Releases the context until `wake`. */
  sleep(): void;
  wake(): void;
}

/** Fewer than any browser allows: the page may have contexts of its own. */
const MOST = 12;

export class Contexts {
  readonly #most: number;
  readonly #seen = new Set<Drawn>();
  /** Awake and out of sight, starting with the drawing that has been out of sight longest. */
  #unseen: Drawn[] = [];

  constructor(most = MOST) {
    this.#most = most;
  }

  /** Adds a drawing that is awake; whether it is visible is not known yet. */
  add(drawn: Drawn): void {
    this.#unseen.unshift(drawn);
    this.#giveBack();
  }

  see(drawn: Drawn): void {
    if (this.#seen.has(drawn)) return;
    this.#seen.add(drawn);
    this.#unseen = this.#unseen.filter((other) => other !== drawn);
    this.#giveBack();
    drawn.wake();
  }

  lose(drawn: Drawn): void {
    if (!this.#seen.delete(drawn)) return;
    this.#unseen.push(drawn);
    this.#giveBack();
  }

  remove(drawn: Drawn): void {
    this.#seen.delete(drawn);
    this.#unseen = this.#unseen.filter((other) => other !== drawn);
  }

  #giveBack(): void {
    const excess = Math.max(0, this.#seen.size + this.#unseen.length - this.#most);
    for (const drawn of this.#unseen.splice(0, excess)) drawn.sleep();
  }
}

/** The contexts of this page. */
export const contexts = new Contexts();
