/**
 * The work stored under one key of the browser's storage: the picture, written once, the document with its history,
 * unfinished drawings, whether the guard against folds is on, whether it is drawn as pixel art, and the last
 * edited pictures that were open before. Tabs share the key: the last change of any of them is read, picture and
 * document together.
 *
 * If the browser refuses storage, as in some private windows, or has no more of it, nothing is stored and nothing fails:
 * the owner is told.
 */
import { readStored, writeStored } from '../io/storage';
import type { Kept } from './workbench';

interface KeptPicture extends Pick<Kept, 'file' | 'name'> {
  readonly mark: string;
}

/** `guarded`, `drawings` and `pixelated` are missing in documents stored by older versions. */
interface KeptDocument
  extends Pick<Kept, 'record' | 'drawings' | 'pixelated'>,
    Partial<Pick<Kept, 'guarded'>> {
  readonly mark: string;
}

/** Of the pictures from before only the last few are stored: each takes as much room as its file. */
const MOST_LEFT = 3;

export class StoredWork {
  readonly #key: string;
  #file: Blob | null = null;
  /** Identifies the picture, so that a document is never restored with another tab's picture. */
  #mark = '';
  #writing: Promise<void> = Promise.resolve();
  #next: readonly [kept: Kept, left: readonly Kept[]] | null = null;
  /** The pictures from before that were stored last. */
  #left: readonly Kept[] | null = null;
  readonly #told: (stored: boolean) => void;

  /** @param told called after each attempt to store a state. */
  constructor(key: string, told: (stored: boolean) => void) {
    this.#key = key;
    this.#told = told;
  }

  /** Null where nothing is stored, or the browser refuses to tell. */
  async read(): Promise<{ readonly kept: Kept; readonly left: readonly Kept[] } | null> {
    try {
      const names = ['picture', 'document', 'left'].map((name) => `${this.#key}/${name}`);
      const [picture, document, left = []] = (await readStored(names)) as [
        KeptPicture?,
        KeptDocument?,
        (readonly Kept[])?,
      ];
      if (!picture || picture.mark !== document?.mark) return null;
      const { file, name, mark } = picture;
      [this.#file, this.#mark] = [file, mark];
      const { record, drawings = [], guarded = false, pixelated } = document;
      const kept = { file, name, record, drawings, guarded, ...(pixelated !== undefined && { pixelated }) };
      this.#left = left;
      return { kept, left };
    } catch {
      return null;
    }
  }

  /**
   * Writes a state. While one is being written, only the newest of the waiting states is kept.
   * @param left edited pictures that were open before, oldest first.
   */
  write(kept: Kept, left: readonly Kept[]): void {
    const idle = this.#next === null;
    this.#next = [kept, left];
    if (idle) this.#writing = this.#writing.then(() => this.#writeNext());
  }

  async #writeNext(): Promise<void> {
    const next = this.#next;
    this.#next = null;
    if (!next) return;
    const [kept, left] = next;
    const { file, name, record, drawings = [], guarded, pixelated } = kept;
    if (file !== this.#file)
      [this.#file, this.#mark] = [file, `${performance.timeOrigin}+${performance.now()}`];
    const mark = this.#mark;
    const markName = `${this.#key}/mark`;
    const [picture, document]: [KeptPicture, KeptDocument] = [
      { file, name, mark },
      { record, drawings, guarded, ...(pixelated !== undefined && { pixelated }), mark },
    ];
    try {
      await writeStored(
        {
          [`${this.#key}/document`]: document,
          ...(left !== this.#left && { [`${this.#key}/left`]: left.slice(-MOST_LEFT) }),
        },
        { name: markName, is: mark, values: { [`${this.#key}/picture`]: picture, [markName]: mark } },
      );
      this.#left = left;
      this.#told(true);
    } catch {
      // Storage full or refused: editing goes on.
      this.#told(false);
    }
  }
}
