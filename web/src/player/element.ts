/**
 * `<c2-warp-player>`: plays a rig, with the attributes, properties, methods and events of `<video>`.
 *
 * Out of sight and in hidden tabs its time stands still, and nothing is computed.
 */
import { cycleOf, frameAt, orderAt, type RigClip } from './clip';
import { advanced } from './clock';
import { borrow, giveBack, type Loaded } from './library';
import { type Stage, stage } from './stage';

/** Seconds of the clock between two `timeupdate` events. */
const UPDATE_S = 0.25;
/** A longer gap between frames is a break, for example of a hidden tab. Milliseconds. */
const BREAK_MS = 250;
/** The longest side of a drawing, device pixels. Some graphics cards have no larger ones. */
const MOST_PX = 4096;

const SHEET = `:host{display:inline-block;position:relative}:host([hidden]),slot[hidden],canvas[hidden]{display:none}canvas{position:absolute;inset:0;width:100%;height:100%}`;

/** Servers have no elements. */
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

export class C2WarpPlayer extends Base {
  static readonly observedAttributes = ['src', 'clip', 'autoplay', 'loop'];

  readonly #canvas: HTMLCanvasElement;
  readonly #slot: HTMLSlotElement;
  readonly #size: CSSStyleSheet;
  readonly #seen: IntersectionObserver;
  readonly #sized: ResizeObserver;
  #stage: Stage | undefined;
  /** The address of the newest source. */
  #address = '';
  /** The address of the shown rig. */
  #shownAddress = '';
  #shown: Loaded | undefined;
  #loading: Promise<void> = Promise.resolve();
  #error: Error | null = null;
  #clip: RigClip | undefined;
  #time = 0;
  #rate = 1;
  #paused = true;
  #ended = false;
  #autoplays = false;
  #isSeen = false;
  #last = Number.NaN;
  #updated = 0;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    this.#canvas = document.createElement('canvas');
    this.#canvas.setAttribute('part', 'canvas');
    this.#canvas.hidden = true;
    this.#slot = document.createElement('slot');
    root.append(this.#canvas, this.#slot);
    // Style sheets of this kind are allowed by every security policy.
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(SHEET);
    this.#size = new CSSStyleSheet();
    root.adoptedStyleSheets = [sheet, this.#size];
    this.attachInternals().role = 'img';
    this.#seen = new IntersectionObserver((entries) => {
      this.#isSeen = entries.at(-1)?.isIntersecting === true;
      this.#last = Number.NaN;
      this.#ask();
    });
    this.#sized = new ResizeObserver((entries) => {
      const { contentRect, devicePixelContentBoxSize } = entries.at(-1) as ResizeObserverEntry;
      // Safari does not know the exact size.
      const exact = devicePixelContentBoxSize?.[0];
      const width = exact?.inlineSize ?? Math.round(contentRect.width * devicePixelRatio);
      const height = exact?.blockSize ?? Math.round(contentRect.height * devicePixelRatio);
      const shrunk = Math.min(1, MOST_PX / Math.max(width, height));
      this.#canvas.width = Math.floor(width * shrunk);
      this.#canvas.height = Math.floor(height * shrunk);
      // At once: a canvas is empty after a change of its size.
      if (this.#isSeen) this.#draw();
    });
  }

  connectedCallback(): void {
    this.#seen.observe(this);
    try {
      this.#sized.observe(this.#canvas, { box: 'device-pixel-content-box' });
    } catch {
      this.#sized.observe(this.#canvas);
    }
    stillness().addEventListener('change', this.#onStillness);
    if (this.src && !this.#address) this.#load();
  }

  disconnectedCallback(): void {
    // An element that is only moved keeps its rig and its time.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#seen.disconnect();
      this.#sized.disconnect();
      stillness().removeEventListener('change', this.#onStillness);
      this.#stage?.cancel(this.#frame);
      this.#isSeen = false;
      this.#leave();
      this.#giveBack();
    });
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (name === 'src' && this.isConnected) this.#load();
    if (name === 'clip' && before !== after) this.#choose();
    if (name === 'autoplay' && after !== null && this.#shown) this.#autoplay();
  }

  get src(): string {
    return this.getAttribute('src') ?? '';
  }

  set src(src: string) {
    this.setAttribute('src', src);
  }

  /** The name of the clip. Without one, the first clip plays. */
  get clip(): string {
    return this.getAttribute('clip') ?? this.#clip?.name ?? '';
  }

  set clip(clip: string) {
    this.setAttribute('clip', clip);
  }

  /** The names of all clips; empty until the rig is there. */
  get clips(): string[] {
    return this.#shown?.rig.clips.map(({ name }) => name) ?? [];
  }

  get autoplay(): boolean {
    return this.hasAttribute('autoplay');
  }

  set autoplay(autoplay: boolean) {
    this.toggleAttribute('autoplay', autoplay);
  }

  get loop(): boolean {
    return this.hasAttribute('loop');
  }

  set loop(loop: boolean) {
    this.toggleAttribute('loop', loop);
  }

  /** Seconds. A clip that alternates lasts there and back. NaN until the rig is there. */
  get duration(): number {
    return this.#clip ? cycleOf(this.#clip) : Number.NaN;
  }

  get currentTime(): number {
    return this.#time;
  }

  set currentTime(time: number) {
    if (!Number.isFinite(time)) throw new TypeError('The time must be a finite number.');
    this.#time = Math.max(0, this.#clip ? Math.min(time, this.duration) : time);
    this.#ended = false;
    this.#update();
    this.#ask();
  }

  get playbackRate(): number {
    return this.#rate;
  }

  set playbackRate(rate: number) {
    if (!Number.isFinite(rate)) throw new TypeError('The rate must be a finite number.');
    this.#rate = rate;
    this.dispatchEvent(new Event('ratechange'));
  }

  get paused(): boolean {
    return this.#paused;
  }

  get ended(): boolean {
    return this.#ended;
  }

  /** Why the source is not shown, or null. */
  get error(): Error | null {
    return this.#error;
  }

  /** Plays, once the rig is there. Rejects if it cannot be shown. */
  async play(): Promise<void> {
    this.#autoplays = false;
    this.#begin();
    await this.#loading;
    if (this.#error) throw this.#error;
  }

  pause(): void {
    this.#autoplays = false;
    this.#stop();
  }

  #begin(): void {
    if (this.#ended) this.#time = 0;
    this.#ended = false;
    if (!this.#paused) return;
    this.#paused = false;
    this.dispatchEvent(new Event('play'));
    this.#ask();
  }

  #stop(): void {
    if (this.#paused) return;
    this.#paused = true;
    this.dispatchEvent(new Event('pause'));
  }

  #autoplay(): void {
    if (stillness().matches || !this.#paused) return;
    this.#autoplays = true;
    this.#begin();
  }

  readonly #onStillness = () => {
    if (!stillness().matches || !this.#autoplays) return;
    this.#autoplays = false;
    this.#stop();
  };

  /** Loads the source. A newer one supersedes it. */
  #load(): void {
    this.#leave();
    this.#error = null;
    if (!this.src) {
      this.#giveBack();
      return;
    }
    const address = new URL(this.src, document.baseURI).href;
    this.#address = address;
    const loading = this.#show(address).catch((error: Error) => {
      // Another source is loading.
      if (this.#loading !== loading) return;
      this.#leave();
      this.#giveBack();
      this.#fail(error);
    });
    this.#loading = loading;
  }

  async #show(address: string): Promise<void> {
    this.#stage = stage();
    const loaded = await borrow(address);
    if (this.#address !== address) return;
    this.#giveBack();
    this.#shown = loaded;
    this.#shownAddress = address;
    this.#address = '';
    const { width, height } = loaded.rig;
    this.#size.replaceSync(`:host{width:${width}px;max-width:100%;aspect-ratio:${width}/${height}}`);
    this.#canvas.hidden = false;
    this.#slot.hidden = true;
    this.#time = 0;
    this.#choose();
    this.dispatchEvent(new Event('loadeddata'));
    if (this.autoplay) this.#autoplay();
  }

  /** Gives back a source that is loading. */
  #leave(): void {
    if (this.#address) giveBack(this.#address, () => {});
    this.#address = '';
  }

  /** Gives back the shown rig, and shows the content of the element again. */
  #giveBack(): void {
    if (!this.#shown) return;
    giveBack(this.#shownAddress, (loaded) => this.#stage?.forget(loaded));
    [this.#shown, this.#clip, this.#shownAddress] = [undefined, undefined, ''];
    this.#canvas.hidden = true;
    this.#slot.hidden = false;
    this.#size.replaceSync('');
  }

  #choose(): void {
    if (!this.#shown) return;
    const { clips } = this.#shown.rig;
    const wanted = this.getAttribute('clip');
    const found = wanted === null ? clips[0] : clips.find(({ name }) => name === wanted);
    if (!found) this.#fail(new Error(`There is no clip “${wanted}”: there is ${listed(this.clips)}.`));
    const before = this.#clip;
    this.#clip = found ?? clips[0];
    if (before && before !== this.#clip) this.currentTime = 0;
    this.#ask();
  }

  #fail(error: Error): void {
    this.#error = error;
    this.dispatchEvent(new ErrorEvent('error', { error, message: error.message }));
  }

  #update(): void {
    this.#updated = this.#time;
    this.dispatchEvent(new Event('timeupdate'));
  }

  #ask(): void {
    if (this.#shown && this.#isSeen) this.#stage?.ask(this.#frame);
  }

  readonly #frame = (now: number): boolean => {
    if (!this.#shown || !this.#isSeen) return false;
    this.#advance(now);
    this.#draw();
    return !this.#paused;
  };

  #advance(now: number): void {
    const gap = Math.min(now - this.#last, BREAK_MS);
    this.#last = this.#paused ? Number.NaN : now;
    // The first frame has none before it.
    if (this.#paused || Number.isNaN(gap)) return;
    const { time, stops } = advanced(this.#time, (gap / 1000) * this.#rate, this.duration, this.loop);
    this.#time = time;
    if (stops) {
      this.#last = Number.NaN;
      this.#ended = time >= this.duration;
      this.#update();
      this.#stop();
      if (this.#ended) this.dispatchEvent(new Event('ended'));
    } else if (Math.abs(time - this.#updated) >= UPDATE_S) this.#update();
  }

  #draw(): void {
    const [loaded, clip] = [this.#shown, this.#clip];
    const { width, height } = this.#canvas;
    const context = this.#canvas.getContext('2d');
    if (!loaded || !clip || !context || width === 0 || height === 0) return;
    const { rig } = loaded;
    const scale = Math.min(width / rig.width, height / rig.height);
    const view = {
      width,
      height,
      scale,
      x: (width - rig.width * scale) / 2,
      y: (height - rig.height * scale) / 2,
    };
    const at = frameAt(clip, this.#time);
    this.#stage?.show(loaded, clip, at, orderAt(clip, at), view, context);
  }
}

const stillness = () => matchMedia('(prefers-reduced-motion: reduce)');

const listed = (names: readonly string[]) => names.map((name) => `“${name}”`).join(', ') || 'none';
