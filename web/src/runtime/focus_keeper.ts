import { isField } from '../ui/untyped';

/** The bars with all their contents except text fields, and other controls that are pressed rather than typed into. */
const CONTROLS = '.top, .tools, .status, .draft-bar, .switch, button, summary';
/** Places where the selected element has the focus, and keeps it. */
const SELECTABLE = '.stage, .clip-key';

/**
 * Keeps the focus in the editor: the focused element may disappear (a deleted handle) or be disabled (the last undo),
 * and browsers then focus nothing. Only a press outside or the Tab key takes the focus away.
 */
export class FocusKeeper {
  readonly #host: HTMLElement;
  readonly #listening = new AbortController();
  #inside = false;

  constructor(host: HTMLElement) {
    this.#host = host;
    const { signal } = this.#listening;
    host.addEventListener('focusin', () => this.#enter(true), { signal });
    // While capturing: a listener inside may render, and so repair, before the event bubbles up to here.
    host.addEventListener('focusout', (event) => event.relatedTarget && this.#enter(false), {
      signal,
      capture: true,
    });
    const elsewhere = (event: Event) => !event.composedPath().includes(host) && this.#enter(false);
    host.addEventListener('mousedown', (event) => this.#press(event), { signal });
    host.shadowRoot?.addEventListener('beforetoggle', (event) => this.#leave(event as ToggleEvent), {
      signal,
      capture: true,
    });
    host.ownerDocument.addEventListener('pointerdown', elsewhere, { signal, capture: true });
    // At the document, an event's path omits the nodes inside a closed shadow root.
    host.addEventListener('pointerdown', () => this.#enter(true), { signal, capture: true });
  }

  /** Restores a lost focus; to be called after each render. */
  repair(): void {
    if (!this.#inside || !this.#isLost()) return;
    // On the stage, it is visible, and Tab continues to the handles.
    const stage = this.#host.shadowRoot?.querySelector<HTMLElement>('.stage[tabindex]');
    (stage ?? this.#host).focus({ preventScroll: true });
  }

  dispose(): void {
    this.#listening.abort();
  }

  /** A pressed control does not take the focus: that stays on the selection, or comes to the editor from elsewhere. */
  #press(event: MouseEvent): void {
    const target = event.composedPath()[0];
    if (!(target instanceof Element) || isField(target)) return;
    if (target.closest(SELECTABLE) || !target.closest(CONTROLS)) return;
    event.preventDefault();
    if (!this.#held?.closest(SELECTABLE)) this.#host.focus({ preventScroll: true });
  }

  /**
   * Whether nothing has the focus, or the focused element is disabled or hidden. Browsers notice that a frame or two
   * later, and keys are lost until then.
   */
  #isLost(): boolean {
    const held = this.#held;
    if (held) return held.matches(':disabled') || !held.checkVisibility({ visibilityProperty: true });
    const { ownerDocument: document } = this.#host;
    return document.activeElement === document.body && document.hasFocus();
  }

  /** A closing menu would drop the focus of an element inside it: its button gets it. */
  #leave({ target, newState }: ToggleEvent): void {
    const menu = target as Element;
    if (newState !== 'closed' || !menu.contains(this.#held)) return;
    const button = this.#host.shadowRoot?.querySelector<HTMLElement>(`[popovertarget="${menu.id}"]`);
    button?.focus({ preventScroll: true });
  }

  /** The focused element in the editor's shadow tree. */
  get #held(): Element | null {
    return this.#host.shadowRoot?.activeElement ?? null;
  }

  #enter(inside: boolean): void {
    this.#inside = inside;
  }
}
