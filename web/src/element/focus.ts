import type { Hit } from '../tools/hit';
import type { Corner } from '../ui/model';
import { isField, untype } from '../ui/untyped';

/** What has the focus inside the editor, and what gets it. */
export class Focus {
  readonly #root: ShadowRoot;
  readonly #changed: () => void;
  #corner: Corner | null = null;

  /** @param changed renders what is about to get the focus, or another corner. */
  constructor(root: ShadowRoot, changed: () => void) {
    this.#root = root;
    this.#changed = changed;
  }

  /** The last corner that had the focus, until a handle or the stage has it: what is done in the panel is for it. */
  get corner(): Corner | null {
    return this.#corner;
  }

  set corner(corner: Corner | null) {
    const before = this.#corner;
    this.#corner = corner;
    if (before?.id !== corner?.id || before?.index !== corner?.index) this.#changed();
  }

  /** Whether a handle or a corner has the focus. */
  get isOnHandles(): boolean {
    return Boolean(this.#root.activeElement?.closest('.handles'));
  }

  /** The handle or the corner that has the focus. */
  get held(): Hit | null {
    const { handle, of, corner } = (this.#root.activeElement as HTMLElement | null)?.dataset ?? {};
    if (handle !== undefined) return { part: 'handle', id: handle };
    return of === undefined ? null : { part: 'corner', id: of, index: Number(corner) };
  }

  /** Whether something is being typed. */
  get isInField(): boolean {
    return isField(this.#root.activeElement);
  }

  /** Whether what is copied is text: in a field, or selected beside the stage. */
  get isOnText(): boolean {
    return this.isInField || (!this.isOnStage && String(getSelection()).trim() !== '');
  }

  get isOnStage(): boolean {
    return Boolean(this.#root.activeElement?.closest('.stage'));
  }

  /** Commits a number being typed before a press changes the selection, since it belongs to the current one. */
  leaveField(): void {
    const active = this.#root.activeElement;
    if (active instanceof HTMLInputElement) active.blur();
  }

  /** Drops a number that is being typed. */
  untypeField(): void {
    const active = this.#root.activeElement;
    if (active instanceof HTMLInputElement && isField(active)) untype(active);
  }

  /** Focuses a handle or one of its corners, or the stage without an id, so that keys go on working. */
  hold(id: string | undefined, corner?: number): void {
    this.#changed();
    queueMicrotask(() => {
      const named = id === undefined ? '' : CSS.escape(id);
      const wanted =
        corner === undefined ? `[data-handle="${named}"]` : `[data-of="${named}"][data-corner="${corner}"]`;
      const handle = id === undefined ? null : this.#root.querySelector(wanted);
      const target = handle ?? this.#root.querySelector('.stage');
      if (target instanceof HTMLElement) target.focus({ preventScroll: true });
    });
  }
}
