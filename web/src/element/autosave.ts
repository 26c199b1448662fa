/** Saves the open work under a key, so that it survives a reload or a crash, and opens it again. */
import { isEngineFailure } from '../compute/errors';
import { StoredWork } from './stored_work';
import { isWorkedOn, type Kept, type Workbench } from './workbench';

export class Autosave {
  readonly #workbench: Workbench;
  #stored: StoredWork | null = null;
  #restoring = false;
  readonly #lost: () => void;
  /** Whether the last attempt to store work has failed. */
  #failing = false;

  /** @param lost called when work is not stored any more: the browser refuses storage, or has no more of it. */
  constructor(workbench: Workbench, lost: () => void) {
    this.#workbench = workbench;
    this.#lost = lost;
  }

  /** Saves under this key from now on; null stops that. */
  use(key: string | null): void {
    this.#stored = key ? new StoredWork(key, (stored) => this.#tell(stored)) : null;
    this.save();
  }

  save(): void {
    const { kept } = this.#workbench;
    if (kept) this.#stored?.write(kept);
  }

  /** A picture that was opened and not touched is no loss. */
  #tell(stored: boolean): void {
    const { kept } = this.#workbench;
    if (stored) this.#failing = false;
    else if (kept && isWorkedOn(kept) && !this.#failing) {
      this.#failing = true;
      this.#lost();
    }
  }

  /** Saves what has just been opened. Restored work is stored already, or has been replaced by newer work of another tab. */
  saveOpened(): void {
    if (!this.#restoring) this.save();
  }

  /**
   * Opens the stored work.
   * @returns the work, or null if there was none that could be opened.
   * @throws Error with the code `engine` without a solver.
   */
  async restore(reopen: (kept: Kept) => Promise<void>): Promise<Kept | null> {
    const kept = await this.#stored?.read();
    if (!kept) return null;
    this.#restoring = true;
    try {
      await reopen(kept);
    } catch (error) {
      // Without a solver nothing can be opened. Any other error means a document that this version does not accept.
      if (isEngineFailure(error)) throw error;
      return null;
    } finally {
      this.#restoring = false;
    }
    // The solver refused the last stored step: store the work without it.
    if (this.#workbench.editing.document !== kept.record.present) this.save();
    return kept;
  }
}
