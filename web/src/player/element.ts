/**
 * `<c2-warp-player>`: plays a rig, with the attributes, properties, methods and events of `<video>`.
 *
 * While it is out of view or in a hidden tab, its time stops and nothing is computed.
 */

import { advanced, hasEnded, type MediaTime, standsStill } from '../document/media_time';
import { asC2WarpError, C2WarpError } from '../error';
import { PlayerAttributes } from './attributes';
import { cycleOf, frameAt, motionAt, motionsAt, orderAt, type RigClip } from './clip';
import { type Grips, gripsOf } from './grips';
import { handlesAt } from './handles_at';
import type { Loaded } from './library';
import { fileHandle, type HandlePose, type PosedHandle, posedClip, posedHandles } from './posed';
import { ownPoser, type Poser, solverOf } from './poser';
import type { Rig } from './rig';
import { type Screen, screenOf } from './screen';
import type { Handle } from './shares';
import { Source } from './source';
import { type Stage, stage } from './stage';

/** Seconds of the clock between two `timeupdate` events. */
const UPDATE_S = 0.25;
/** The time of the glide from the last frame of a drag to the pose in which it rests. Seconds. */
const GLIDE_S = 0.24;
/** A longer gap between frames is a pause, for example in a hidden tab. Milliseconds. */
const BREAK_MS = 250;

/**
 * A player of rigs, with the interface of `<video>`.
 *
 * @slot - Shown until the rig is loaded, and if loading fails, unless a poster is set.
 * @csspart canvas - The picture.
 * @csspart poster - The image of `poster`.
 * @csspart handle - The grip of a handle, with `posable`.
 */
export class C2WarpPlayer extends PlayerAttributes {
  static readonly observedAttributes = [
    'src',
    'clip',
    'autoplay',
    'loop',
    'poster',
    'alt',
    'width',
    'height',
    'posable',
  ];

  readonly #internals = this.attachInternals();
  readonly #grips: Grips;
  readonly #screen: Screen;
  #stage: Stage | undefined;
  readonly #source: Source;
  #error: C2WarpError | null = null;
  #clip: RigClip | undefined;
  /** The handles as posed by the page, instead of the clip. */
  #posed: readonly Handle[] | undefined;
  /** The same as a clip; undefined while the solver loads. */
  #posedClip: RigClip | undefined;
  /** The part of its glide that is over, from 0 to 1. */
  #glided = 1;
  /** The poser of the present rig; null while the solver loads, and for a rig that cannot be posed. */
  #poser: Poser | null = null;
  #time = 0;
  #rate = 1;
  #paused = true;
  #autoplays = false;
  #last = Number.NaN;
  #updated = 0;

  constructor() {
    super();
    this.#internals.role = 'img';
    this.#grips = gripsOf(this, {
      moved: (id, [x, y]) =>
        this.#alter(id, ({ posed }) => ({ posed: posed.map(([px, py]) => [px + x, py + y] as const) })),
      reset: (id) =>
        this.#alter(id, ({ rest, rotation }) => ({
          posed: rest,
          rotation: rotation === 'auto' ? rotation : 0,
          scale: 1,
        })),
      ended: () => {
        if (this.#posed) this.#pose(this.#posed, this.#motions, true);
        this.dispatchEvent(new Event('change', { bubbles: true }));
      },
    });
    this.#source = new Source({
      begun: () => {
        this.#stage = stage();
      },
      shown: (loaded) => this.#begun(loaded),
      left: () => {
        [this.#clip, this.#posed, this.#poser] = [undefined, undefined, null];
        this.#screen.showPicture(null);
        this.#grips.show(null, null);
      },
      forgotten: (loaded) => this.#stage?.forget(loaded),
      failed: (thrown) => this.#fail(asC2WarpError(thrown)),
    });
    this.#screen = screenOf(this, this.#grips.element, {
      seen: () => {
        this.#last = Number.NaN;
        this.#ask();
      },
      // At once, before the empty canvas is seen.
      sized: () => {
        if (this.#screen.isSeen) this.#draw();
      },
    });
  }

  connectedCallback(): void {
    // Properties that the page set before the element was defined hide the accessors.
    for (const [name, value] of Object.entries(this)) {
      if (!(name in C2WarpPlayer.prototype)) continue;
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
    this.#screen.watch();
    stillness().addEventListener('change', this.#onStillness);
    if (this.src !== this.#source.address) this.#load();
  }

  disconnectedCallback(): void {
    // An element that is only moved keeps its rig and its time.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#screen.unwatch();
      stillness().removeEventListener('change', this.#onStillness);
      this.#stage?.cancel(this.#frame);
      this.#source.release();
    });
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (name === 'src' && this.isConnected) this.#load();
    if (name === 'clip' && before !== after) this.#choose();
    if (name === 'poster') this.#screen.setPoster(after ?? '');
    if (name === 'posable') this.#offer();
    if (name === 'alt') this.#internals.ariaLabel = after;
    if (name === 'width' || name === 'height') this.#screen.setSize(this.givenSize);
    if (name === 'autoplay' && after !== null && this.#source.loaded) this.#autoplay();
    if (name === 'loop') this.#ask();
  }

  /**
   * The name of the clip. By default, the first clip plays.
   *
   * @attr
   * @default ''
   */
  get clip(): string {
    return this.getAttribute('clip') ?? this.#clip?.name ?? '';
  }

  set clip(clip: string) {
    this.reflect('clip', clip);
  }

  /** The names of all clips; empty until the rig is loaded. */
  get clips(): string[] {
    return this.#source.loaded?.rig.clips.map(({ name }) => name) ?? [];
  }

  /**
   * A copy of the handles in their present poses, as in a project. It is empty until the rig is loaded, and for rigs
   * that cannot be posed.
   */
  get handles(): PosedHandle[] {
    return this.#handles().map(fileHandle);
  }

  /**
   * Pauses the clip and poses handles, until the clip plays or a time is set. Takes the handles of a project, or ids
   * with changes. If the poses of a rig need the solver, the first pose loads it, and is then shown.
   *
   * @param handles Positions in pixels of the picture, degrees, and scale factors.
   * @throws RangeError if a handle does not exist, or a pose is invalid; TypeError without a list. On an error,
   *   no handle moves.
   * @throws C2WarpError if the rig is not loaded yet, or cannot be posed.
   */
  pose(handles: readonly HandlePose[]): void {
    if (!this.#source.loaded) throw new C2WarpError('no-picture', 'load a rig before you pose it');
    const { shares, solved } = this.#source.loaded.rig;
    if (!(shares || solved))
      throw new C2WarpError('rig', 'this rig cannot be posed: it was baked without the poses of its handles');
    this.#pose(posedHandles(this.#handles(), handles, solved !== null));
    this.#loadSolver();
  }

  /** Seconds. For a clip that alternates, forwards and backwards together. NaN until the rig is loaded. */
  get duration(): number {
    return this.#clip ? cycleOf(this.#clip) : Number.NaN;
  }

  /**
   * Seconds. Setting it shows that time of the clip.
   *
   * @default 0
   * @throws TypeError for anything but a finite number.
   */
  get currentTime(): number {
    return this.#time;
  }

  set currentTime(time: number) {
    if (!Number.isFinite(time)) throw new TypeError('The time must be a finite number.');
    this.#seek(Math.max(0, this.#clip ? Math.min(time, this.duration) : time));
    if (this.ended) this.#end();
  }

  /**
   * The speed. Below 0, the clip plays backwards, and stands still at the beginning, as videos do.
   *
   * @default 1
   * @throws TypeError for anything but a finite number.
   */
  get playbackRate(): number {
    return this.#rate;
  }

  set playbackRate(rate: number) {
    if (!Number.isFinite(rate)) throw new TypeError('The rate must be a finite number.');
    this.#rate = rate;
    this.dispatchEvent(new Event('ratechange'));
    this.#ask();
  }

  /** Whether the clip is paused. */
  get paused(): boolean {
    return this.#paused;
  }

  /** Whether the clip has played to its end. */
  get ended(): boolean {
    return hasEnded(this.#at);
  }

  /** Why the source or the clip is not shown, or null. */
  get error(): C2WarpError | null {
    return this.#error;
  }

  /**
   * Plays the clip, from the beginning if it has ended, and resolves once the rig is loaded.
   *
   * @throws C2WarpError if the rig cannot be shown.
   */
  async play(): Promise<void> {
    this.#autoplays = false;
    this.#begin();
    await this.#source.loading;
    if (this.#error) throw this.#error;
  }

  /** Pauses. */
  pause(): void {
    this.#autoplays = false;
    this.#stop();
  }

  /** The handles with their shown poses. */
  #handles(): readonly Handle[] {
    const { shares, solved, rest } = this.#source.loaded?.rig ?? {};
    const sources = shares ?? solved;
    const shown = this.#shown;
    if (this.#posed || !sources || !rest || !shown) return this.#posed ?? [];
    return handlesAt(sources, motionAt(shown.clip, rest.length / 2, shown.at), rest);
  }

  /** The shown clip or pose, and its frame. */
  get #shown(): { readonly clip: RigClip; readonly at: number } | undefined {
    // The picture comes to rest slowly.
    if (this.#posed && this.#posedClip) return { clip: this.#posedClip, at: 1 - (1 - this.#glided) ** 3 };
    return this.#clip && { clip: this.#clip, at: frameAt(this.#clip, this.#time) };
  }

  /** The shown motions, sites × 6. */
  get #motions(): Float64Array | undefined {
    const { rig } = this.#source.loaded ?? {};
    const shown = this.#shown;
    return rig && shown && motionsAt(shown.clip, rig.rest.length / 2, shown.at);
  }

  /** Shows a pose. With `before`, it continues these motions. With `rests`, it is the end of a drag. */
  #pose(handles: readonly Handle[], before?: Float64Array, rests = false): void {
    const { rig } = this.#source.loaded ?? {};
    const glides = rests && !stillness().matches;
    this.#posedClip =
      rig && this.#poser
        ? posedClip(rig, this.#poser(handles, before, rests), glides ? before : undefined)
        : undefined;
    this.#glided = glides ? 0 : 1;
    this.pause();
    this.#posed = handles;
    this.#ask();
  }

  /** Loads the solver if the rig needs it. Then shows a waiting pose, and the grips. */
  async #loadSolver(): Promise<void> {
    const { rig } = this.#source.loaded ?? {};
    if (!rig?.solved || this.#poser) return;
    const isShown = (of: Rig) => of === this.#source.loaded?.rig;
    try {
      const poser = await solverOf(rig, rig.solved);
      if (!isShown(rig)) return;
      this.#poser = poser;
      if (this.#posed) this.#pose(this.#posed);
      this.#offer();
    } catch (thrown) {
      if (!isShown(rig)) return;
      // Clips play on.
      this.#posed = undefined;
      this.#tell(asC2WarpError(thrown));
      this.#ask();
    }
  }

  /** A reader changes the pose of a handle. */
  #alter(id: string, change: (handle: Handle) => Partial<Handle>): void {
    const one = (handle: Handle) => (handle.id === id ? { ...handle, ...change(handle) } : handle);
    this.#pose(this.#handles().map(one), this.#motions);
    this.dispatchEvent(new Event('input', { bubbles: true }));
  }

  /** Shows or hides grips. */
  #offer(): void {
    if (this.posable) this.#loadSolver();
    // An image has no parts for screen readers.
    this.#internals.role = this.#hasGrips ? 'group' : 'img';
    this.#ask();
  }

  get #hasGrips(): boolean {
    return this.posable && this.#poser !== null;
  }

  /** The time by the rules of media elements. */
  get #at(): MediaTime {
    return { time: this.#time, rate: this.#rate, length: this.duration, loops: this.loop };
  }

  get #moves(): boolean {
    return this.#posed ? this.#glided < 1 : !this.#paused && !standsStill(this.#at);
  }

  #seek(time: number): void {
    this.#time = time;
    this.#posed = undefined;
    this.#update();
    this.#ask();
  }

  /** The clip has come to its end. */
  #end(): void {
    if (this.ended) this.#stop();
    this.dispatchEvent(new Event('ended'));
  }

  #begin(): void {
    if (this.ended) this.#seek(0);
    this.#posed = undefined;
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
    this.#error = null;
    this.#source.load(this.src);
  }

  #begun({ rig }: Loaded): void {
    this.#screen.showPicture(rig);
    this.#poser = ownPoser(rig);
    this.#offer();
    this.#time = 0;
    this.#choose();
    this.dispatchEvent(new Event('loadeddata'));
    if (this.autoplay) this.#autoplay();
  }

  #choose(): void {
    if (!this.#source.loaded) return;
    const { clips } = this.#source.loaded.rig;
    const wanted = this.getAttribute('clip');
    const found = wanted === null ? clips[0] : clips.find(({ name }) => name === wanted);
    if (found) this.#error = null;
    else
      this.#fail(new C2WarpError('clip', `There is no clip “${wanted}”. The rig has ${listed(this.clips)}.`));
    const before = this.#clip;
    this.#clip = found ?? clips[0];
    if (before && before !== this.#clip) this.#seek(0);
    this.#ask();
  }

  #fail(error: C2WarpError): void {
    this.#error = error;
    this.#tell(error);
  }

  #tell(error: C2WarpError): void {
    this.dispatchEvent(new ErrorEvent('error', { error, message: error.message }));
  }

  #update(): void {
    this.#updated = this.#time;
    this.dispatchEvent(new Event('timeupdate'));
  }

  #ask(): void {
    if (this.#source.loaded && this.#screen.isSeen) this.#stage?.ask(this.#frame);
  }

  readonly #frame = (now: number): boolean => {
    if (!this.#source.loaded || !this.#screen.isSeen) return false;
    if (this.#moves) this.#advance(Math.min(now - this.#last, BREAK_MS) / 1000);
    this.#draw();
    this.#last = this.#moves ? now : Number.NaN;
    return this.#moves;
  };

  #advance(seconds: number): void {
    // The first frame has none before it.
    if (Number.isNaN(seconds)) return;
    if (this.#posed) {
      this.#glided = Math.min(1, this.#glided + seconds / GLIDE_S);
      return;
    }
    this.#time = advanced(this.#at, seconds);
    const ends = this.ended;
    if (ends || !this.#moves || Math.abs(this.#time - this.#updated) >= UPDATE_S) this.#update();
    if (ends) this.#end();
  }

  #draw(): void {
    const loaded = this.#source.loaded;
    const shown = this.#shown;
    const { context } = this.#screen;
    const view = loaded && this.#screen.viewOf(loaded.rig);
    if (!loaded || !shown || !context || !view) return;
    const { clip, at } = shown;
    this.#stage?.show(loaded, clip, at, orderAt(clip, at), view, context);
    this.#grips.show(this.#hasGrips ? this.#handles() : null, view);
  }
}

const stillness = () => matchMedia('(prefers-reduced-motion: reduce)');

const listed = (names: readonly string[]) => names.map((name) => `“${name}”`).join(', ') || 'none';
