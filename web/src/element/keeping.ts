/**
 * Keeps what is open in the browser's own storage, so that a reload or a crash brings it back: the picture once, the
 * document with its history after every step.
 *
 * Where the browser grants no storage, as in some private windows, nothing is kept and nothing fails.
 */
import { readKept, writeKept } from '../io/storage';
import type { Kept } from './workbench';

export class Keeping {
  readonly #key: string;
  #file: Blob | null = null;
  #writing: Promise<void> = Promise.resolve();
  #next: Kept | null = null;

  constructor(key: string) {
    this.#key = key;
  }

  async restore(): Promise<Kept | null> {
    try {
      const [picture, document] = await Promise.all([
        readKept<Pick<Kept, 'file' | 'name'>>(`${this.#key}/picture`),
        readKept<Pick<Kept, 'record' | 'name'>>(`${this.#key}/document`),
      ]);
      if (!picture || !document || picture.name !== document.name) return null;
      this.#file = picture.file;
      return { ...picture, record: document.record };
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
    const { file, name, record } = kept;
    try {
      if (file !== this.#file) await writeKept(`${this.#key}/picture`, { file, name });
      this.#file = file;
      await writeKept(`${this.#key}/document`, { name, record });
    } catch {
      // Storage full or refused: the work in hand is not touched by it.
    }
  }
}
