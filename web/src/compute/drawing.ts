/** A warped picture in straight alpha, which the worker draws in bands of rows. */
import { superseded } from './errors';
import type { Link } from './link';
import type { DrawingSize } from './messages';
import type { Pixels } from './solution';

/** Pixels per band: a band takes about 50 ms, and newer requests wait for one or two bands. */
const BAND_PIXELS = 2 ** 18;

export class Drawing {
  readonly width: number;
  readonly height: number;
  /** The picture's upper left corner in the drawing. */
  readonly origin: readonly [x: number, y: number];
  readonly #link: Link;
  readonly #id: number;
  readonly #rows: number;
  readonly #isCurrent: () => boolean;

  /** @param isCurrent Whether the worker still has the picture of the drawing. */
  constructor(
    link: Link,
    { drawing, width, height, origin, bandRows }: DrawingSize,
    isCurrent: () => boolean,
  ) {
    this.#link = link;
    this.#id = drawing;
    this.width = width;
    this.height = height;
    this.origin = origin;
    this.#rows = Math.max(1, Math.floor(BAND_PIXELS / width / bandRows)) * bandRows;
    this.#isCurrent = isCurrent;
  }

  /**
   * All rows from top to bottom, once. The worker draws one band ahead. Leaving the loop releases the drawing.
   * @throws DOMException `AbortError` when another picture comes first; C2WarpError otherwise.
   */
  async *bands(): AsyncGenerator<Uint8Array<ArrayBuffer>, void> {
    try {
      let next: Promise<Uint8Array<ArrayBuffer>> | null = this.#band(0);
      for (let from = 0; next; ) {
        const band: Promise<Uint8Array<ArrayBuffer>> = next;
        from += this.#rows;
        next = from < this.height ? this.#band(from) : null;
        // Nobody awaits the band ahead if this one fails or the loop is left.
        next?.catch(() => {});
        yield await band;
      }
    } finally {
      this.release();
    }
  }

  /** Frees its memory in the worker. */
  release(): void {
    this.#link.send('release', { drawing: this.#id }).catch(() => {});
  }

  /** All rows at once. */
  async pixels(): Promise<Pixels> {
    const rgba = new Uint8Array(this.width * this.height * 4);
    let at = 0;
    for await (const band of this.bands()) {
      rgba.set(band, at);
      at += band.length;
    }
    return { width: this.width, height: this.height, rgba };
  }

  async #band(from: number): Promise<Uint8Array<ArrayBuffer>> {
    try {
      const to = Math.min(from + this.#rows, this.height);
      return await this.#link.send('rows', { drawing: this.#id, from, to });
    } catch (error) {
      throw this.#isCurrent() ? error : superseded();
    }
  }
}
