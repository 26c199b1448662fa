/** The borders between the cells of the shown solution: asked of the worker once they are to be shown, and again for another. */
import type { CellBorders } from '../compute/solution';
import type { Solved } from './solving';
import type { Workbench } from './workbench';

export interface BorderingHost {
  readonly workbench: Workbench;
  /** The borders have come. */
  changed(): void;
}

export class Bordering {
  readonly #host: BorderingHost;
  #solved: Solved | null = null;
  #borders: CellBorders | null = null;

  constructor(host: BorderingHost) {
    this.#host = host;
  }

  /** Null as long as they are not there. */
  borders(): CellBorders | null {
    const { current } = this.#host.workbench.solving;
    if (current !== this.#solved) {
      [this.#solved, this.#borders] = [current, null];
      if (current) void this.#ask(current);
    }
    return this.#borders;
  }

  async #ask(solved: Solved): Promise<void> {
    try {
      const borders = await this.#host.workbench.solving.cells(solved);
      if (solved !== this.#solved) return;
      this.#borders = borders;
      this.#host.changed();
    } catch {
      // The picture has been replaced, or the solver is gone, which is told by what it was asked for first.
    }
  }
}
