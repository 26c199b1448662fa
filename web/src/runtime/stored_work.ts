/**
 * The work stored under one key of the browser's storage: picture, document with history, unfinished drawings,
 * settings, and the last edited pictures before that. The picture is written once. Tabs share the key: the last change
 * of any of them is read, picture and document together.
 *
 * If the browser refuses storage, as in some private windows, or has no more of it, nothing is stored and nothing
 * fails. The owner hears of it.
 */
import type { WorkSnapshot } from '../editor/work';
import { readStored, writeStored } from '../io/storage';

/** A picture and its documents carry the same mark. */
interface StoredPicture extends Pick<WorkSnapshot, 'file' | 'name'> {
  readonly mark: string;
}

/** `guarded`, `drawings` and `pixelated` are missing in documents stored by older versions. */
interface StoredDocument
  extends Pick<WorkSnapshot, 'record' | 'drawings' | 'pixelated'>,
    Partial<Pick<WorkSnapshot, 'guarded'>> {
  readonly mark: string;
}

/** Only the last few parked works are stored: each takes as much room as its file. */
const MAX_PARKED = 3;

export class StoredWork {
  readonly #key: string;
  readonly #stored: (stored: boolean) => void;
  #file: WorkSnapshot['file'] | null = null;
  /** Identifies the picture, so that a document is never restored with another tab's picture. */
  #mark = '';
  #writing: Promise<void> = Promise.resolve();
  #next: readonly [work: WorkSnapshot, parked: readonly WorkSnapshot[]] | null = null;
  /** The parked works that were stored last. */
  #parked: readonly WorkSnapshot[] | null = null;

  /** @param stored called after each attempt to store a state. */
  constructor(key: string, stored: (stored: boolean) => void) {
    this.#key = key;
    this.#stored = stored;
  }

  /** Null if nothing is stored, or the browser refuses to read. */
  async read(): Promise<{ readonly work: WorkSnapshot; readonly parked: readonly WorkSnapshot[] } | null> {
    try {
      const names = ['picture', 'document', 'left'].map((name) => `${this.#key}/${name}`);
      const [picture, document, parked = []] = (await readStored(names)) as [
        StoredPicture?,
        StoredDocument?,
        (readonly WorkSnapshot[])?,
      ];
      if (!picture || picture.mark !== document?.mark) return null;
      const { file, name, mark } = picture;
      [this.#file, this.#mark] = [file, mark];
      const { record, drawings = [], guarded = false, pixelated } = document;
      const work = { file, name, record, drawings, guarded, ...(pixelated !== undefined && { pixelated }) };
      this.#parked = parked;
      return { work, parked };
    } catch {
      return null;
    }
  }

  /** Writes a state. While one is being written, only the newest of the waiting states is kept. */
  write(work: WorkSnapshot, parked: readonly WorkSnapshot[]): void {
    const idle = this.#next === null;
    this.#next = [work, parked];
    if (idle) this.#writing = this.#writing.then(() => this.#writeNext());
  }

  async #writeNext(): Promise<void> {
    const next = this.#next;
    this.#next = null;
    if (!next) return;
    const [{ file, name, record, drawings = [], guarded, pixelated }, parked] = next;
    if (file !== this.#file)
      [this.#file, this.#mark] = [file, `${performance.timeOrigin}+${performance.now()}`];
    const mark = this.#mark;
    const markName = `${this.#key}/mark`;
    const picture: StoredPicture = { file, name, mark };
    const settings = { guarded, ...(pixelated !== undefined && { pixelated }) };
    const document: StoredDocument = { record, drawings, ...settings, mark };
    try {
      await writeStored(
        {
          [`${this.#key}/document`]: document,
          ...(parked !== this.#parked && { [`${this.#key}/left`]: parked.slice(-MAX_PARKED) }),
        },
        { name: markName, is: mark, values: { [`${this.#key}/picture`]: picture, [markName]: mark } },
      );
      this.#parked = parked;
      this.#stored(true);
    } catch {
      // Storage is full or refused: editing goes on.
      this.#stored(false);
    }
  }
}
