/** Bars with all that is in them, and what else is pressed and not typed into. */
const CONTROLS = '.top, .tools, .status, .draft-bar, .switch, button, summary';

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

  /** A pressed control does its work and leaves the keys with the picture, or gives them back from a field or a control that has them. */
  #press(event: MouseEvent): void {
    const target = event.composedPath()[0];
    if (!(target instanceof Element) || target.closest('.stage') || !target.closest(CONTROLS)) return;
    event.preventDefault();
    if (!this.#held?.closest('.stage')) this.#host.focus({ preventScroll: true });
  }

  /** Whether nobody has the focus, or what has it can no longer hold it: browsers notice that a frame or two later, and lose keys. */
  #isLost(): boolean {
    const held = this.#held;
    if (held) return held.matches(':disabled') || !held.checkVisibility({ visibilityProperty: true });
    const { ownerDocument: document } = this.#host;
    return document.activeElement === document.body && document.hasFocus();
  }

  /** A menu that closes takes what has the focus with it. */
  #leave({ target, newState }: ToggleEvent): void {
    if (newState === 'closed' && (target as Element).contains(this.#held))
      this.#host.focus({ preventScroll: true });
  }

  /** What has the focus in here. */
  get #held(): Element | null {
    return this.#host.shadowRoot?.activeElement ?? null;
  }

  #enter(inside: boolean): void {
    this.#inside = inside;
  }
}
