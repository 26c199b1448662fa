/**
 * Which drawings of a page have a WebGL context. Browsers give a page some 16, and take the oldest away for one more, seen
 * or not; here those that have been out of sight for longest give theirs back in time.
 */

export interface Drawn {
  /** Gives the context back until `wake`. */
  sleep(): void;
  wake(): void;
}

/** Fewer than any browser gives: the page may have contexts of its own. */
const MOST = 12;

export class Contexts {
  readonly #most: number;
  readonly #seen = new Set<Drawn>();
  /** Awake and out of sight, those that have been so for longest first. */
  #unseen: Drawn[] = [];

  constructor(most = MOST) {
    this.#most = most;
  }

  /** One that is awake, and of which nobody knows yet whether it is in sight. */
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

/** Of this page. */
export const contexts = new Contexts();
