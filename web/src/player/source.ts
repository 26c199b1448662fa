/** The source of a player: loads rigs, of which the newest wins, and releases rigs that are no longer shown. */
import { borrow, giveBack, type Loaded } from './library';

interface Listeners {
  /** Called before a rig is loaded. @throws C2WarpError if rigs cannot be shown. */
  begun(): void;
  shown(loaded: Loaded): void;
  /** A rig is no longer shown. */
  left(): void;
  /** Its graphics are no longer needed. */
  forgotten(loaded: Loaded): void;
  failed(thrown: unknown): void;
}

export class Source {
  readonly #listeners: Listeners;
  /** The address that is loading; empty if nothing is loading. */
  #awaited = '';
  /** The address of the shown rig. */
  #address = '';
  #loaded: Loaded | undefined;
  #loading: Promise<void> = Promise.resolve();

  constructor(listeners: Listeners) {
    this.#listeners = listeners;
  }

  /** The shown rig. */
  get loaded(): Loaded | undefined {
    return this.#loaded;
  }

  /** The newest address. */
  get address(): string {
    return this.#awaited || this.#address;
  }

  /** Resolves once the newest source is shown, or has failed. */
  get loading(): Promise<void> {
    return this.#loading;
  }

  /** Loads a source, which supersedes the previous one; an empty address shows nothing. */
  load(address: string): void {
    this.#leave();
    if (!address) {
      this.#giveBack();
      return;
    }
    this.#awaited = address;
    const loading = this.#show(address).catch((thrown: unknown) => {
      // Another source is loading.
      if (this.#loading !== loading) return;
      this.release();
      this.#listeners.failed(thrown);
    });
    this.#loading = loading;
  }

  release(): void {
    this.#leave();
    this.#giveBack();
  }

  async #show(address: string): Promise<void> {
    this.#listeners.begun();
    const loaded = await borrow(address);
    if (this.#awaited !== address) return;
    this.#giveBack();
    this.#loaded = loaded;
    this.#address = address;
    this.#awaited = '';
    this.#listeners.shown(loaded);
  }

  /** Releases a source that is loading. */
  #leave(): void {
    if (this.#awaited) giveBack(this.#awaited, () => {});
    this.#awaited = '';
  }

  /** Releases the shown rig. */
  #giveBack(): void {
    if (!this.#loaded) return;
    giveBack(this.#address, this.#listeners.forgotten);
    this.#loaded = undefined;
    this.#address = '';
    this.#listeners.left();
  }
}
