/** Saves the open work under a key, so that it survives a reload or a crash, and opens it again. */
import { isEngineFailure } from '../compute/errors';
import type { Files } from './files';
import { isAbort } from './latest';
import { StoredWork } from './stored_work';
import { isWorkedOn, type Kept, type Workbench } from './workbench';

export interface AutosaveHost {
  /** Work is not stored any more: the browser refuses storage, or has no more of it. */
  lost(): void;
  /** Another tab has stored its own work under the key, over that of this one. */
  overwritten(): void;
}

/** Tells one step from another: to select something is none. */
const stepOf = ({ name, record: { past, future } }: Kept): string =>
  [name, past.length, past.at(-1)?.label, future.length].join();

export class Autosave {
  readonly #workbench: Workbench;
  readonly #files: Files;
  #stored: StoredWork | null = null;
  #restoring = false;
  /** Whether what is stored could not be opened: it stays until there is other work. */
  #unread = false;
  readonly #host: AutosaveHost;
  /** Between all tabs that store under the key. */
  #others: BroadcastChannel | null = null;
  /** The last step that was stored, and whether the others are to be told of it. */
  #step = '';
  #untold = false;
  /** Whether another tab was the last to store a step, and that has been told. */
  #overwritten = false;
  /** Whether the last attempt to store work has failed. */
  #failing = false;

  constructor(workbench: Workbench, files: Files, host: AutosaveHost) {
    this.#workbench = workbench;
    this.#files = files;
    this.#host = host;
  }

  /** Saves under this key from now on; null stops that. */
  use(key: string | null): void {
    this.#stored = key ? new StoredWork(key, (stored) => this.#tell(stored)) : null;
    this.#unread = false;
    this.#others?.close();
    this.#others = key ? new BroadcastChannel(`c2warp/${key}`) : null;
    this.#others?.addEventListener('message', () => this.#hear());
    this.save();
  }

  /** Stores nothing more. */
  release(): void {
    this.#stored = null;
    this.#others?.close();
  }

  save(): void {
    const { kept } = this.#workbench;
    if (!kept || (this.#unread && !isWorkedOn(kept))) return;
    this.#unread = false;
    const step = stepOf(kept);
    this.#untold ||= step !== this.#step;
    this.#step = step;
    this.#stored?.write(kept, this.#files.left);
  }

  /** A picture that was opened and not touched is no loss. */
  #tell(stored: boolean): void {
    const { kept } = this.#workbench;
    if (stored) {
      this.#failing = false;
      if (!this.#untold) return;
      this.#untold = false;
      this.#overwritten = false;
      this.#others?.postMessage(null);
    } else if (kept && isWorkedOn(kept) && !this.#failing) {
      this.#failing = true;
      this.#host.lost();
    }
  }

  #hear(): void {
    const { kept } = this.#workbench;
    if (this.#overwritten || !kept || !isWorkedOn(kept)) return;
    this.#overwritten = true;
    this.#host.overwritten();
  }

  /** Saves what has just been opened. Restored work is stored already, or has been replaced by newer work of another tab. */
  saveOpened(): void {
    if (!this.#restoring) this.save();
  }

  /**
   * Opens the stored work.
   * @param failed takes why it could not be opened. The way back leads to it, and it stays stored until there is other work.
   * @returns the work, or null if none is open.
   * @throws Error with the code `engine` without a solver; DOMException `AbortError` once something else is open.
   */
  async restore(
    reopen: (kept: Kept) => Promise<void>,
    failed: (error: unknown) => void,
  ): Promise<Kept | null> {
    const stored = await this.#stored?.read();
    if (!stored) return null;
    const { kept, left } = stored;
    this.#step = stepOf(kept);
    this.#files.left = left;
    this.#restoring = true;
    try {
      await reopen(kept);
    } catch (error) {
      // Without a solver nothing can be opened.
      if (isEngineFailure(error) || isAbort(error)) throw error;
      this.#unread = true;
      this.#files.left = [...this.#files.left, kept];
      failed(error);
      return null;
    } finally {
      this.#restoring = false;
    }
    // The solver refused the last stored step: store the work without it.
    if (this.#workbench.editing.document !== kept.record.present) this.save();
    return kept;
  }
}
