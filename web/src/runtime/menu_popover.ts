/**
 * The context menu on the page: shown beside its place, with the focus, which returns to where it was.
 *
 * The menu closes when anything else is pressed or scrolled. A press on the stage does no more than that.
 */

import type { EditorState } from '../editor/state';
import { toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import { stageToClient } from '../ui/client';
import { showMenu } from '../ui/context_menu';

/**
 * Between a place and the menu, CSS pixels: a finger covers the place, and keys are about a handle that must be seen.
 */
const GAP_CSS_PX = { mouse: 2, other: 16 } as const;

export class MenuPopover {
  readonly #root: ShadowRoot;
  readonly #close: () => void;
  /** The element that had the focus before. */
  #before: Element | null = null;
  #listening = new AbortController();

  constructor(root: ShadowRoot, close: () => void) {
    this.#root = root;
    this.#close = close;
  }

  /** Shows the menu beside a place of the picture, once it is rendered. */
  show(at: Vec, { view, pointer }: EditorState): void {
    queueMicrotask(() => {
      const menu = this.#menu;
      const stage = this.#root.querySelector('.stage');
      if (!menu || !stage) return;
      this.#before = this.#root.activeElement;
      const keyed = this.#root.host.classList.contains('keyed');
      const gap = keyed || pointer.coarse ? GAP_CSS_PX.other : GAP_CSS_PX.mouse;
      showMenu(menu, stageToClient(stage, toStage(view.camera, at)), gap, keyed);
      this.#listen();
    });
  }

  /** Ends the display: the focus returns to where it was. */
  hide(): void {
    this.#listening.abort();
    const before = this.#before?.isConnected ? this.#before : this.#root.querySelector('.stage');
    if (this.#menu?.contains(this.#root.activeElement))
      (before as HTMLElement).focus({ preventScroll: true });
  }

  dispose(): void {
    this.#listening.abort();
  }

  #listen(): void {
    this.#listening.abort();
    this.#listening = new AbortController();
    const { signal } = this.#listening;
    const { ownerDocument } = this.#root;
    const view = ownerDocument.defaultView;
    /** The last press in the editor: outside of it, the target of a press may be hidden. */
    let inside: Event | null = null;
    const pressed = (event: Event) => {
      inside = event;
      const target = event.target as Element;
      if (target.closest('.context')) return;
      this.#close();
      if (target.closest('.stage')) event.preventDefault();
    };
    const scrolled = (event: Event) => {
      if (!(event.target as Element).closest('.context')) this.#close();
    };
    const close = () => this.#close();
    this.#root.addEventListener('pointerdown', pressed, { signal, capture: true });
    this.#root.addEventListener('wheel', scrolled, { signal, capture: true, passive: true });
    view?.addEventListener('pointerdown', (event) => event !== inside && close(), { signal });
    ownerDocument.addEventListener('scroll', close, { signal, capture: true, passive: true });
    view?.addEventListener('resize', close, { signal });
    view?.addEventListener('blur', close, { signal });
  }

  get #menu(): HTMLElement | null {
    return this.#root.querySelector('.context');
  }
}
