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
    // A menu that closes leaves the focus with nobody.
    host.shadowRoot?.addEventListener('toggle', () => this.repair(), { signal, capture: true });
    document.addEventListener('pointerdown', elsewhere, { signal, capture: true });
  }

  /** To be called after each change of what is shown. */
  repair(): void {
    this.#takeBack();
    // Browsers notice a disabled control at the end of the next frame only.
    requestAnimationFrame(() => requestAnimationFrame(() => this.#takeBack()));
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

  #takeBack(): void {
    const lost = document.activeElement === document.body && document.hasFocus();
    if (this.#inside && lost) this.#host.focus({ preventScroll: true });
  }

  #enter(inside: boolean): void {
    this.#inside = inside;
  }
}
