/**
 * Escape dismisses a tooltip, wherever the pointer and the focus are (WCAG 1.4.13). So does a press on its button or on
 * the tooltip, which may cover something else. The next hover or focus of its button shows it again.
 *
 * Escape first ends work in progress, and leaves the tooltip: a drag, a drawing, the crosshair, an open menu or sheet,
 * a number field. Everything else that Escape does waits for its next press.
 */
import { noChange } from 'lit-html';
import { AsyncDirective, directive } from 'lit-html/async-directive.js';
import type { ElementPart } from 'lit-html/directive.js';
import type { EditorModel } from '../editor/view_model';

/** Marks buttons whose tooltip is dismissed. `style/tooltips.ts` shows none there. */
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

  /** Listens on the window, since a hover shows a tooltip wherever the focus is. */
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

/** Dismisses the tooltip of a pressed button, or a pressed tooltip. Whatever lies under it gets the next press. */
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
  // With the focus elsewhere, the page gets the key too.
  if (held && shown.length > 0) event.preventDefault();
}

/** Whether a button's tooltip is visible. Before it fades in, nothing needs to be dismissed. */
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
  // A press dismisses the tooltip and focuses the button: only focus by keys shows it again.
  const byKeys = () => button.matches(':focus-visible') && show();
  button.addEventListener('focus', byKeys, { signal: again.signal });
}

/** Handles the tooltips in `.shell`. */
export const tooltips = directive(Tooltips);
