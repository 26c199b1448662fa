/**
 * Escape dismisses a shown tooltip, wherever the pointer and the focus are (WCAG 1.4.13), and so does a press: on the
 * button, after which the pointer goes on to what may lie under the tooltip, or on the tooltip, which is none on its
 * button. The next hover or focus of its button shows it again.
 *
 * What a person is in the midst of goes first and leaves the tooltip: a drag, a drawing, the crosshair, an open menu or
 * sheet of settings, a number field. All else that Escape does waits for the next press, such as to let go of what is
 * selected.
 */
import { noChange } from 'lit';
import { AsyncDirective, directive } from 'lit/async-directive.js';
import type { ElementPart } from 'lit/directive.js';
import type { EditorModel } from './model';

/** On buttons whose tooltip is dismissed: `style/tooltips.ts` shows none there. */
const DISMISSED = 'data-dismissed';

class Tooltips extends AsyncDirective {
  #shell: Element | null = null;
  #listening: AbortController | null = null;
  #busy = false;

  override render(_model: EditorModel): typeof noChange {
    return noChange;
  }

  override update({ element }: ElementPart, [model]: [EditorModel]): typeof noChange {
    this.#shell = element;
    this.#busy = model.pressing || model.settings || model.draft !== null || model.crosshair !== null;
    if (this.isConnected && !this.#listening) this.#listen(element);
    return noChange;
  }

  override disconnected(): void {
    this.#listening?.abort();
    this.#listening = null;
  }

  override reconnected(): void {
    if (this.#shell) this.#listen(this.#shell);
  }

  /** On the window: a tooltip is shown by hover while the focus is anywhere on the page. */
  #listen(shell: Element): void {
    this.#listening = new AbortController();
    const { signal } = this.#listening;
    const onKey = (event: KeyboardEvent) => {
      if (event.key === 'Escape' && !this.#busy) dismissIn(shell, event);
    };
    shell.ownerDocument.defaultView?.addEventListener('keydown', onKey, { signal, capture: true });
    shell.addEventListener('pointerdown', (event) => pressed(event as PointerEvent), {
      signal,
      capture: true,
    });
  }
}

/** Dismisses the tooltip of a button that is pressed, or that itself is: what lies under it gets the next press. */
function pressed(event: PointerEvent): void {
  const button = (event.target as Element).closest('[data-tip]');
  if (!button) return;
  if (!isOver(button.getBoundingClientRect(), event)) event.stopPropagation();
  dismiss(button);
}

const isOver = ({ left, top, right, bottom }: DOMRect, { clientX, clientY }: PointerEvent): boolean =>
  clientX >= left && clientX <= right && clientY >= top && clientY <= bottom;

function dismissIn(shell: Element, event: Event): void {
  const held = (shell.getRootNode() as ShadowRoot).activeElement;
  if (held?.matches('.field input') || shell.querySelector(':popover-open')) return;
  const shown = [...shell.querySelectorAll('[data-tip]')].filter(isShown);
  for (const button of shown) dismiss(button);
  // With the focus elsewhere the key is the page's too.
  if (held && shown.length > 0) event.preventDefault();
}

/** Whether a button's tooltip can be seen: before it fades in nothing is there to dismiss. */
function isShown(button: Element): boolean {
  const { content, opacity } = getComputedStyle(button, '::after');
  return content !== 'none' && Number(opacity) > 0;
}

function dismiss(button: Element): void {
  button.setAttribute(DISMISSED, '');
  const again = new AbortController();
  const show = () => {
    button.removeAttribute(DISMISSED);
    again.abort();
  };
  button.addEventListener('pointerenter', show, { signal: again.signal });
  // A press, which dismisses too, gives a button the focus.
  const byKeys = () => button.matches(':focus-visible') && show();
  button.addEventListener('focus', byKeys, { signal: again.signal });
}

/** On `.shell`, for the tooltips in it. */
export const tooltips = directive(Tooltips);
