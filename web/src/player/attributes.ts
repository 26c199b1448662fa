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
    return this.getAttribute('src') ?? '';
  }

  set src(src: string) {
    this.setAttribute('src', src);
  }

  /**
   * The address of an image that is shown until the rig is loaded, and if loading fails.
   *
   * @attr
   * @default ''
   */
  get poster(): string {
    return this.getAttribute('poster') ?? '';
  }

  set poster(poster: string) {
    this.setAttribute('poster', poster);
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
    this.setAttribute('alt', alt);
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
    this.toggleAttribute('posable', posable);
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
    this.toggleAttribute('autoplay', autoplay);
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
    this.toggleAttribute('loop', loop);
  }

  /** @internal The size that the page sets, or null. */
  protected get givenSize(): Size | null {
    const [width, height] = ['width', 'height'].map((name) => Number(this.getAttribute(name)));
    return width && height && width > 0 && height > 0 ? { width, height } : null;
  }
}
