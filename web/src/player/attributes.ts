/** The attributes of `<c2-warp-player>` as properties. */
import type { Size } from './screen';

/** Servers have no elements. */
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

export class PlayerAttributes extends Base {
  /**
   * The address of the rig. A new address replaces the rig, and the newest wins.
   *
   * @attr
   * @default ''
   */
  get src(): string {
    return this.#address('src');
  }

  set src(src: string) {
    this.reflect('src', src);
  }

  /**
   * The address of an image that is shown until the rig is loaded, and if loading fails.
   *
   * @attr
   * @default ''
   */
  get poster(): string {
    return this.#address('poster');
  }

  set poster(poster: string) {
    this.reflect('poster', poster);
  }

  /**
   * A description of the picture for screen readers.
   *
   * @attr
   * @default ''
   */
  get alt(): string {
    return this.getAttribute('alt') ?? '';
  }

  set alt(alt: string) {
    this.reflect('alt', alt);
  }

  /**
   * Lets readers pose the handles, by pointer and by keyboard.
   *
   * @attr
   * @default false
   */
  get posable(): boolean {
    return this.hasAttribute('posable');
  }

  set posable(posable: boolean) {
    this.toggleAttribute('posable', Boolean(posable));
  }

  /**
   * Plays once the rig is loaded, unless the user prefers reduced motion.
   *
   * @attr
   * @default false
   */
  get autoplay(): boolean {
    return this.hasAttribute('autoplay');
  }

  set autoplay(autoplay: boolean) {
    this.toggleAttribute('autoplay', Boolean(autoplay));
  }

  /**
   * Repeats the clip.
   *
   * @attr
   * @default false
   */
  get loop(): boolean {
    return this.hasAttribute('loop');
  }

  set loop(loop: boolean) {
    this.toggleAttribute('loop', Boolean(loop));
  }

  /**
   * The width in CSS pixels, for the shape before the rig is loaded. It requires `height`.
   *
   * @attr
   * @default 0
   */
  get width(): number {
    return this.#pixels('width');
  }

  set width(width: number) {
    this.reflect('width', width);
  }

  /**
   * The height in CSS pixels, for the same purpose.
   *
   * @attr
   * @default 0
   */
  get height(): number {
    return this.#pixels('height');
  }

  set height(height: number) {
    this.reflect('height', height);
  }

  /** @internal The size that the page sets, or null. */
  protected get givenSize(): Size | null {
    const { width, height } = this;
    return width && height ? { width, height } : null;
  }

  /** Absolute, as in HTML. */
  #address(name: string): string {
    const text = this.getAttribute(name);
    try {
      return text ? new URL(text, this.baseURI).href : '';
    } catch {
      return text ?? '';
    }
  }

  /** A whole number from 0, as in HTML. */
  #pixels(name: string): number {
    const pixels = Number.parseInt(this.getAttribute(name) ?? '', 10);
    return pixels >= 0 && pixels < 2 ** 31 ? pixels : 0;
  }

  /** @internal Frameworks take a property back by null or undefined. */
  protected reflect(name: string, value: unknown): void {
    if (value == null) this.removeAttribute(name);
    else this.setAttribute(name, String(value));
  }
}
