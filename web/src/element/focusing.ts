/**
 * Keeps the keys with the editor: what has the focus may vanish (a deleted handle) or be disabled (the last undo), and
 * browsers then give it to nobody. Only a press elsewhere or the Tab key takes it away.
 */
export class Focusing {
  readonly #host: HTMLElement;
  readonly #listening = new AbortController();
  #inside = false;

  constructor(host: HTMLElement) {
    this.#host = host;
    const { signal } = this.#listening;
    host.addEventListener('focusin', () => this.#enter(true), { signal });
    host.addEventListener('focusout', (event) => event.relatedTarget && this.#enter(false), { signal });
    const elsewhere = (event: Event) => !event.composedPath().includes(host) && this.#enter(false);
    host.addEventListener('mousedown', (event) => this.#press(event), { signal });
    host.shadowRoot?.addEventListener('beforetoggle', (event) => this.#leave(event as ToggleEvent), {
      signal,
      capture: true,
    });
    host.ownerDocument.addEventListener('pointerdown', elsewhere, { signal, capture: true });
    // The path of an event does not tell a document what lies in a closed shadow.
    host.addEventListener('pointerdown', () => this.#enter(true), { signal, capture: true });
  }

  /** To be called after each change of what is shown. */
  repair(): void {
    if (this.#inside && this.#isLost()) this.#host.focus({ preventScroll: true });
  }

  release(): void {
    this.#listening.abort();
  }

  /** A pressed button of a bar does its work and leaves the keys where they were: with the picture. */
  #press(event: MouseEvent): void {
    const target = event.composedPath()[0];
    if (!(target instanceof Element) || !target.closest('.top, .tools, .status')) return;
    event.preventDefault();
    if (!this.#inside) this.#host.focus({ preventScroll: true });
  }

  /** Whether nobody has the focus, or what has it can no longer hold it: browsers notice that a frame or two later, and lose keys. */
  #isLost(): boolean {
    const held = this.#host.shadowRoot?.activeElement;
    if (held) return held.matches(':disabled') || !held.checkVisibility({ visibilityProperty: true });
    const { ownerDocument: document } = this.#host;
    return document.activeElement === document.body && document.hasFocus();
  }

  /** A menu that closes takes what has the focus with it. */
  #leave({ target, newState }: ToggleEvent): void {
    const held = this.#host.shadowRoot?.activeElement ?? null;
    if (newState === 'closed' && (target as Element).contains(held))
      this.#host.focus({ preventScroll: true });
  }

  #enter(inside: boolean): void {
    this.#inside = inside;
  }
}
