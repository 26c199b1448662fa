/**
 * Keeps what is open in the browser's own storage, so that a reload or a crash brings it back: the picture once, the
 * document with its history after every step, and whether the guard against folds is on. Several tabs have one place there: what changed last is what comes back, whole.
 *
 * Where the browser grants no storage, as in some private windows, nothing is kept and nothing fails.
 */
import { readKept, writeKept } from '../io/storage';
import type { Kept } from './workbench';

interface KeptPicture extends Pick<Kept, 'file' | 'name'> {
  readonly mark: string;
}

/** What an older version has kept says nothing of the guard. */
interface KeptDocument extends Pick<Kept, 'record'>, Partial<Pick<Kept, 'guarded'>> {
  readonly mark: string;
}

export class Keeping {
  readonly #key: string;
  #file: Blob | null = null;
  /** Tells the picture from those of other tabs: a document is worth nothing with another. */
  #mark = '';
  #writing: Promise<void> = Promise.resolve();
  #next: Kept | null = null;

  constructor(key: string) {
    this.#key = key;
  }

  async restore(): Promise<Kept | null> {
    try {
      const names = [`${this.#key}/picture`, `${this.#key}/document`];
      const [picture, document] = (await readKept(names)) as [KeptPicture?, KeptDocument?];
      if (!picture || picture.mark !== document?.mark) return null;
      const { file, name, mark } = picture;
      [this.#file, this.#mark] = [file, mark];
      const { record, guarded = false } = document;
      return { file, name, record, guarded };
    } catch {
      return null;
    }
  }

  /** Writes the newest state; states that come while one is written replace one another. */
  keep(kept: Kept): void {
    const idle = this.#next === null;
    this.#next = kept;
    if (idle) this.#writing = this.#writing.then(() => this.#write());
  }

  async #write(): Promise<void> {
    const kept = this.#next;
    this.#next = null;
    if (!kept) return;
    const { file, name, record, guarded } = kept;
    if (file !== this.#file)
      [this.#file, this.#mark] = [file, `${performance.timeOrigin}+${performance.now()}`];
    const mark = this.#mark;
    const markName = `${this.#key}/mark`;
    const [picture, document]: [KeptPicture, KeptDocument] = [
      { file, name, mark },
      { record, guarded, mark },
    ];
    try {
      await writeKept(
        { [`${this.#key}/document`]: document },
        { name: markName, is: mark, values: { [`${this.#key}/picture`]: picture, [markName]: mark } },
      );
    } catch {
      // Storage full or refused: the work in hand is not touched by it.
    }
  }
}
