/** Where the bytes of a film go. */
import { say, type Wording } from '../../texts/wording';
import { Refused } from './refused';

type Bytes = Uint8Array<ArrayBuffer>;

export interface FilmOutput {
  /** Writes bytes, nearly always after the last ones. Resolves once more can be written. */
  write(position: number, bytes: Bytes): Promise<void>;
  /** The whole film; null if it is in a file. */
  finish(): Promise<Blob | null>;
  /** Leaves nothing of an unfinished film behind. */
  abandon(): Promise<void>;
}

/** The storage of the film failed, not its encoder. */
export class StorageRefused extends Refused {
  override readonly fault = 'storage';
}

const full = (error: unknown): boolean =>
  error instanceof DOMException && error.name === 'QuotaExceededError';

const reasonOf = (error: unknown): Wording =>
  say(full(error) ? 'errors.writing.reasons.diskFull' : 'errors.writing.reasons.diskRefuses');

/** Bytes that are gathered before they become a blob, which the browser keeps out of the worker's memory. */
const FOLDED = 8 * 2 ** 20;

/** A film in blobs, for browsers that cannot write to a picked file. */
export class BlobOutput implements FilmOutput {
  readonly #type: string;
  #blob: Blob;
  /** Bytes behind the blob. */
  #parts: Bytes[] = [];
  #length = 0;
  /** Bytes for places that were written before. */
  readonly #patches: { readonly position: number; readonly bytes: Bytes }[] = [];

  constructor(type: string) {
    this.#type = type;
    this.#blob = new Blob([], { type });
  }

  async write(position: number, bytes: Bytes): Promise<void> {
    if (position < this.#length) {
      this.#patches.push({ position, bytes });
      return;
    }
    // A gap is filled later.
    if (position > this.#length) this.#parts.push(new Uint8Array(position - this.#length));
    this.#parts.push(bytes);
    this.#length = position + bytes.length;
    if (this.#length - this.#blob.size >= FOLDED) this.#fold();
  }

  async finish(): Promise<Blob> {
    this.#fold();
    for (const { position, bytes } of this.#patches) {
      const [before, after] = [this.#blob.slice(0, position), this.#blob.slice(position + bytes.length)];
      this.#blob = new Blob([before, bytes, after], { type: this.#type });
    }
    return this.#blob;
  }

  async abandon(): Promise<void> {
    this.#parts = [];
    this.#blob = new Blob([]);
  }

  #fold(): void {
    this.#blob = new Blob([this.#blob, ...this.#parts], { type: this.#type });
    this.#parts = [];
  }
}

/** A film in a file that the person has picked. The file gets its contents at the end. */
export class PickedOutput implements FilmOutput {
  readonly #file: FileSystemFileHandle;
  #stream: FileSystemWritableFileStream | null = null;

  constructor(file: FileSystemFileHandle) {
    this.#file = file;
  }

  async write(position: number, data: Bytes): Promise<void> {
    await this.#try(async () => {
      this.#stream ??= await this.#file.createWritable();
      await this.#stream.write({ type: 'write', position, data });
    });
  }

  async finish(): Promise<null> {
    await this.#try(async () => this.#stream?.close());
    this.#stream = null;
    return null;
  }

  async abandon(): Promise<void> {
    // A stream that has failed is gone already.
    await this.#stream?.abort().catch(() => {});
    this.#stream = null;
  }

  /** @throws StorageRefused */
  async #try(write: () => Promise<void>): Promise<void> {
    try {
      await write();
    } catch (error) {
      throw new StorageRefused(reasonOf(error));
    }
  }
}
