/** The frames of a clip, drawn by the worker one after another along one way. */
import { Drawing } from './drawing';
import { superseded } from './errors';
import type { Link } from './link';
import type { DrawingSize, FilmSize } from './messages';

export class Filming {
  readonly #link: Link;
  #size: FilmSize;
  readonly #isCurrent: () => boolean;

  /** @param isCurrent Whether the worker still has the picture of the film. */
  constructor(link: Link, size: FilmSize, isCurrent: () => boolean) {
    this.#link = link;
    this.#size = size;
    this.#isCurrent = isCurrent;
  }

  /** The pixels and the number of all frames, and whether the film begins again after the last one. */
  get size(): FilmSize {
    return this.#size;
  }

  /**
   * Grows all frames to hold all that one of them draws. Call it for each frame before any of them is drawn.
   * @throws the errors of {@link frame}.
   */
  async include(frame: number): Promise<void> {
    this.#size = await this.#answer(this.#link.send('include', { film: this.#size.film, frame }));
  }

  /**
   * A frame, counted from 0, ready to be drawn. Cheapest in their order.
   * @throws DOMException `AbortError` when another picture comes first; C2WarpError otherwise.
   */
  frame(frame: number): Promise<Drawing> {
    return this.#drawing(this.#link.send('frame', { film: this.#size.film, frame }));
  }

  /**
   * All of the picture at the scale of the film: it has the colours of all frames.
   *
   * @throws the errors of {@link frame}.
   */
  atRest(): Promise<Drawing> {
    return this.#drawing(this.#link.send('at-rest', { film: this.#size.film }));
  }

  /** Frees its memory in the worker. */
  release(): void {
    this.#link.send('release-film', { film: this.#size.film }).catch(() => {});
  }

  async #drawing(size: Promise<DrawingSize>): Promise<Drawing> {
    return new Drawing(this.#link, await this.#answer(size), this.#isCurrent);
  }

  async #answer<T>(asked: Promise<T>): Promise<T> {
    try {
      return await asked;
    } catch (error) {
      throw this.#isCurrent() ? error : superseded();
    }
  }
}
