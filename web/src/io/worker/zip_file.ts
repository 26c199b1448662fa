/** A zip archive, written file by file. Pictures are compressed already, so they are stored uncompressed. */

import { Zip, ZipPassThrough } from 'fflate';
import { say } from '../../texts/wording';
import { Refused } from './refused';

type Bytes = Uint8Array<ArrayBuffer>;
type Take = (position: number, bytes: Bytes) => Promise<void>;

/** Bytes of an archive without the extension for larger ones, which few programs read. */
const MOST_BYTES = 2 ** 32 - 1;
const TOO_LARGE = say('errors.writing.reasons.zipTooLarge');

export class ZipFile {
  readonly #take: Take;
  readonly #zip: Zip;
  #parts: Bytes[] = [];
  #length = 0;

  constructor(take: Take) {
    this.#take = take;
    this.#zip = new Zip((error, bytes) => {
      if (error) throw error;
      this.#parts.push(bytes as Bytes);
    });
  }

  /** Begins a file. Returns a function that adds bytes to it; `last` ends it. */
  begin(name: string): (bytes: Uint8Array, last: boolean) => Promise<void> {
    const file = new ZipPassThrough(name);
    this.#zip.add(file);
    return async (bytes, last) => {
      file.push(bytes, last);
      await this.#drain();
    };
  }

  /** @throws Refused if the archive is too large. */
  async finish(): Promise<void> {
    this.#zip.end();
    await this.#drain();
  }

  async #drain(): Promise<void> {
    const parts = this.#parts;
    this.#parts = [];
    for (const bytes of parts) {
      const position = this.#length;
      this.#length += bytes.length;
      if (this.#length > MOST_BYTES) throw new Refused(TOO_LARGE);
      // A copy, because the archive may continue to use its own.
      await this.#take(position, bytes.slice());
    }
  }
}
