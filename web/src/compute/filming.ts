/** The frames of a clip, drawn by the worker one after another along one way. */
import { Drawing } from './drawing';
import { superseded } from './errors';
import type { Link } from './link';
import type { DrawingSize, FilmSize } from './messages';

export class Filming {
  readonly width: number;
  readonly height: number;
  readonly frames: number;
  /** The film begins again after its last frame. */
  readonly endlessly: boolean;
  readonly #link: Link;
  readonly #id: number;
  readonly #isCurrent: () => boolean;

  /** @param isCurrent Whether the worker still has the picture of the film. */
  constructor(link: Link, { film, width, height, frames, endlessly }: FilmSize, isCurrent: () => boolean) {
    this.#link = link;
    this.#id = film;
    this.width = width;
    this.height = height;
    this.frames = frames;
    this.endlessly = endlessly;
    this.#isCurrent = isCurrent;
  }

  /**
   * A frame, counted from 0, ready to be drawn. Cheapest in their order.
   * @throws DOMException `AbortError` when another picture comes first; WarpError otherwise.
   */
  frame(frame: number): Promise<Drawing> {
    return this.#drawing(this.#link.send('frame', { film: this.#id, frame }));
  }

  /** All of the picture at the scale of the film: it has the colours of all frames. @throws as {@link frame}. */
  atRest(): Promise<Drawing> {
    return this.#drawing(this.#link.send('at-rest', { film: this.#id }));
  }

  /** Frees its memory in the worker. */
  release(): void {
    this.#link.send('release-film', { film: this.#id }).catch(() => {});
  }

  async #drawing(size: Promise<DrawingSize>): Promise<Drawing> {
    try {
      return new Drawing(this.#link, await size, this.#isCurrent);
    } catch (error) {
      throw this.#isCurrent() ? error : superseded();
    }
  }
}
