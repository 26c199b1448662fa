/**
 * The work stored under one key of the browser's storage: picture, document with history, unfinished drawings,
 * settings, and recent work. A picture is written once.
 *
 * Tabs share the key. The last change of any of them is read, picture and document together. A tab that replaces the
 * work of another keeps it among the recent work, as a version from that tab: nothing is lost.
 *
 * If the browser refuses storage, as in some private windows, or has no more of it, nothing is stored and nothing
 * fails. The owner is notified. Work of a newer version stays as it is, and the owner is notified, too.
 */
import { bounded } from '../editor/recent';
import { packed, unpacked } from '../editor/stored_displacements';
import { isWorkedOn, type WorkSnapshot } from '../editor/work';
import { inTransaction, type StoredValues } from '../io/storage';

/** The form of stored work. A version that stores what this one cannot read has a greater number. */
const FORMAT = 1;

/** A newer version stored the work. */
class NewerWork extends Error {}

/** Whether work was stored: `newer` if that of a newer version is kept in its place. */
type Stored = boolean | 'newer';

/** A picture and its documents carry the same mark. */
type StoredPicture = Pick<WorkSnapshot, 'id' | 'file' | 'name' | 'thumbnail'> & { readonly mark: string };

type StoredDocument = Pick<
  WorkSnapshot,
  | 'record'
  | 'drawings'
  | 'pixelated'
  | 'guarded'
  | 'snapping'
  | 'edgeSnapping'
  | 'saved'
  | 'exports'
  | 'films'
  | 'engines'
  | 'maps'
  | 'exportKind'
> & {
  readonly mark: string;
  /** The tab that wrote it, and a name for this version. */
  readonly writer: string;
  readonly version: string;
  readonly format?: number;
};

/** `kept`: when it was stored, in ms. Later works have greater numbers, also after the clock is set back. */
type StoredRecent = WorkSnapshot & { readonly kept: number; readonly format?: number };

interface Waiting {
  readonly work: WorkSnapshot | null;
  readonly recent: readonly WorkSnapshot[];
  readonly changed: boolean;
}

const unique = (): string => `${performance.timeOrigin + performance.now()}-${Math.random()}`;

export class StoredWork {
  readonly #key: string;
  readonly #stored: (stored: Stored, newest: boolean) => void;
  readonly #writer = unique();
  #file: WorkSnapshot['file'] | null = null;
  /** Identifies the picture, so that a document is never restored with another tab's picture. */
  #mark = '';
  /** The stored version that this tab knows. */
  #version: string | undefined;
  #writes = 0;
  #busy: Promise<unknown> = Promise.resolve();
  #next: Waiting | null = null;
  /** The greatest `kept` that this tab knows. */
  #lastKept = 0;
  /** The recent works that were stored last, by their ids. */
  #recent: ReadonlyMap<string, WorkSnapshot> = new Map();

  /** @param stored called after each attempt to store a state; `newest`: no newer state waits. */
  constructor(key: string, stored: (stored: Stored, newest: boolean) => void) {
    this.#key = key;
    this.#stored = stored;
  }

  /** Null if this version can read nothing in the storage, or if the browser denies access. */
  async read(): Promise<{ readonly work: WorkSnapshot; readonly recent: readonly WorkSnapshot[] } | null> {
    const reading = inTransaction('readonly', async (values) => ({
      ...(await this.#current(values)),
      recent: (await values.under(`${this.#key}/recent/`)) as readonly StoredRecent[],
    }));
    // Writes wait for it: they depend on the result.
    this.#busy = reading.catch(() => {});
    try {
      const { picture, document, recent } = await reading;
      if (!picture || !document) return null;
      [this.#file, this.#mark, this.#version] = [picture.file, picture.mark, document.version];
      this.#lastKept = Math.max(0, ...recent.map(({ kept }) => kept));
      const known = recent
        .filter((work) => !isNewer(work))
        .sort((a, b) => a.kept - b.kept)
        .map(({ kept: _, format: __, ...work }) => unpacked(work));
      this.#recent = byId(known);
      return { work: unpacked(joined(picture, document)), recent: bounded(known) };
    } catch {
      return null;
    }
  }

  /** Writes a state. While one is being written, only the newest of the waiting states is kept. */
  write(work: WorkSnapshot | null, recent: readonly WorkSnapshot[], changed: boolean): void {
    const before = this.#next;
    this.#next = { work: work ?? before?.work ?? null, recent, changed: changed || before?.changed === true };
    if (!before) this.#busy = this.#busy.then(() => this.#writeNext());
  }

  async #writeNext(): Promise<void> {
    const next = this.#next;
    this.#next = null;
    if (!next) return;
    try {
      const version = await inTransaction('readwrite', async (values) => {
        this.#putRecent(values, next.recent);
        return next.work && this.#putWork(values, next.work, next.changed);
      });
      if (version) this.#version = version;
      this.#recent = byId(next.recent);
      this.#stored(true, this.#next === null);
    } catch (error) {
      // Storage is full or denied, or holds newer work: editing continues.
      this.#stored(isOfNewer(error) ? 'newer' : false, this.#next === null);
    }
  }

  /** Writes only the changes, since other tabs may have added to the list. */
  #putRecent(values: StoredValues, recent: readonly WorkSnapshot[]): void {
    const now = byId(recent);
    for (const id of this.#recent.keys()) if (!now.has(id)) values.delete(this.#nameOf(id));
    for (const work of now.values()) {
      if (this.#recent.get(work.id) !== work)
        values.put(this.#nameOf(work.id), { ...packed(work), kept: this.#now(), format: FORMAT });
    }
  }

  /** A time after all that this tab knows. */
  #now(): number {
    // A thousandth apart, so that works that are stored together keep their order.
    this.#lastKept = Math.max(Date.now(), this.#lastKept + 0.001);
    return this.#lastKept;
  }

  /** Returns the version that it writes; null if another tab's newer work stays. */
  async #putWork(values: StoredValues, work: WorkSnapshot, changed: boolean): Promise<string | null> {
    const { picture, document } = await this.#current(values);
    if (picture && document && document.version !== this.#version) {
      if (!changed) return null;
      const theirs = joined(picture, document);
      if (isWorkedOn(theirs)) this.#putVersion(values, theirs, document.writer);
    }
    // An earlier version of this tab is part of this one.
    values.delete(this.#nameOf(this.#writer));
    const { id, file, name, thumbnail, record, drawings = [], guarded, ...more } = packed(work);
    const { snapping, edgeSnapping, pixelated, saved, exports, films, engines, maps, exportKind } = more;
    if (file !== this.#file) [this.#file, this.#mark] = [file, unique()];
    const mark = this.#mark;
    if (picture?.mark !== mark) values.put(`${this.#key}/picture`, { id, file, name, thumbnail, mark });
    // A selection makes no other version.
    const known = document && !changed ? document.version : null;
    const version = known ?? `${this.#writer}/${++this.#writes}`;
    const settings = {
      guarded,
      ...(snapping !== undefined && { snapping }),
      ...(edgeSnapping !== undefined && { edgeSnapping }),
      ...(pixelated !== undefined && { pixelated }),
      ...(saved && { saved }),
      ...(exports && { exports }),
      ...(films && { films }),
      ...(engines && { engines }),
      ...(maps && { maps }),
      ...(exportKind && { exportKind }),
    };
    const writer = this.#writer;
    values.put(`${this.#key}/document`, {
      record,
      drawings,
      ...settings,
      mark,
      writer,
      version,
      format: FORMAT,
    });
    return version;
  }

  #putVersion(values: StoredValues, work: WorkSnapshot, id: string): void {
    values.put(this.#nameOf(id), { ...work, id, fromOtherTab: true, kept: this.#now(), format: FORMAT });
  }

  /**
   * The stored picture and its document; neither if they do not belong together.
   *
   * @throws NewerWork if a newer version stored them.
   */
  async #current(values: StoredValues): Promise<{ picture?: StoredPicture; document?: StoredDocument }> {
    const picture = (await values.get(`${this.#key}/picture`)) as StoredPicture | undefined;
    const document = (await values.get(`${this.#key}/document`)) as StoredDocument | undefined;
    if (document && isNewer(document)) throw new NewerWork();
    return picture && document && picture.mark === document.mark ? { picture, document } : {};
  }

  #nameOf(id: string): string {
    return `${this.#key}/recent/${id}`;
  }
}

const isNewer = ({ format = 1 }: { readonly format?: number }): boolean => format > FORMAT;

/** Whether newer work is the reason: the browser names a database of a newer version so. */
const isOfNewer = (error: unknown): boolean =>
  error instanceof NewerWork || (error instanceof DOMException && error.name === 'VersionError');

const byId = (works: readonly WorkSnapshot[]): ReadonlyMap<string, WorkSnapshot> =>
  new Map(works.map((work) => [work.id, work]));

function joined({ mark: _, ...picture }: StoredPicture, document: StoredDocument): WorkSnapshot {
  const { mark, writer, version, format, ...rest } = document;
  return { ...picture, ...rest };
}
