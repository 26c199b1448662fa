/** The language in which an element shows its texts: the language of its position on the page, once it is loaded. */
import { followLanguage, inheritedLanguage } from './inherited_language';
import { ENGLISH, followLanguages, type Language, languageFor } from './languages';

interface Listeners {
  /** Another language or direction is requested. The element keeps its language until the new one is loaded. */
  asked(): void;
  /** The texts have changed. */
  changed(): void;
  /** A language could not be loaded. */
  failed(cause: unknown): void;
}

export class ShownLanguage {
  readonly #node: Element;
  readonly #listeners: Listeners;
  #language: Language = ENGLISH;
  /** The tag that the page requests; null before it was looked up. */
  #wanted: string | null = null;

  constructor(node: Element, listeners: Listeners) {
    this.#node = node;
    this.#listeners = listeners;
  }

  get current(): Language {
    return this.#language;
  }

  /** Uses the language of the element's position, and follows its changes until the signal is aborted. */
  follow(signal: AbortSignal): void {
    followLanguage(this.#node, () => this.#take(), signal);
    followLanguages(() => void this.#load(), signal);
    this.#take();
  }

  #take(): void {
    this.#listeners.asked();
    const wanted = inheritedLanguage(this.#node);
    if (wanted === this.#wanted) return;
    this.#wanted = wanted;
    void this.#load();
  }

  async #load(): Promise<void> {
    const wanted = this.#wanted ?? '';
    const language = await languageFor(wanted, this.#listeners.failed);
    if (wanted !== this.#wanted) return;
    this.#language = language;
    this.#listeners.changed();
  }
}
