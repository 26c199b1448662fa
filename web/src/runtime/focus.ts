/** The focus in the shadow tree: moves it for the editor, and reports where it is. */
import type { ControlName, FocusTarget } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import { isField, untype } from '../ui/untyped';

export class Focus {
  readonly #root: ShadowRoot;

  constructor(root: ShadowRoot) {
    this.#root = root;
  }

  /** Whether something is being typed. */
  get isInField(): boolean {
    return isField(this.#root.activeElement);
  }

  /** Whether a copy is one of text: in a field, or selected beside the stage. */
  get isOnText(): boolean {
    const onStage = Boolean(this.#root.activeElement?.closest('.stage'));
    return this.isInField || (!onStage && String(getSelection()).trim() !== '');
  }

  /** Commits a number being typed before a press changes the selection that the number belongs to. */
  leaveField(): void {
    const active = this.#root.activeElement;
    if (active instanceof HTMLInputElement) active.blur();
  }

  /** Drops a number that is being typed. */
  untypeField(): void {
    const active = this.#root.activeElement;
    if (active instanceof HTMLInputElement && isField(active)) untype(active);
  }

  /** Focuses a handle or one of its corners once it is rendered, or else the stage, so that keys keep working. */
  move({ handle, corner, ring }: FocusTarget): void {
    queueMicrotask(() => {
      const id = handle === null ? '' : CSS.escape(handle);
      const wanted = corner === null ? `[data-handle="${id}"]` : `[data-of="${id}"][data-corner="${corner}"]`;
      const outlined = ring && `[data-ring="${ring.ring}"][data-ring-corner="${ring.index}"]`;
      const button = handle === null && !outlined ? null : this.#root.querySelector(outlined ?? wanted);
      const target = button ?? this.#root.querySelector('.stage');
      if (target instanceof HTMLElement) target.focus({ preventScroll: true });
    });
  }

  /** Focuses a control once it is rendered, and selects the text of a field. */
  moveToControl(control: ControlName): void {
    queueMicrotask(() => {
      const target = this.#root.querySelector<HTMLElement>(`[data-control="${control}"]`);
      target?.focus();
      if (target instanceof HTMLInputElement && isField(target)) target.select();
    });
  }

  /** Reports where the focus is from now on, until the signal aborts. */
  watch(dispatch: Dispatch, signal: AbortSignal): void {
    this.#root.addEventListener('focusin', ({ target }) => report(target as Element, dispatch), { signal });
    const left = (event: Event) => {
      const { relatedTarget } = event as FocusEvent;
      if (!this.#root.contains(relatedTarget as Node | null)) dispatch({ type: 'focus-lost' });
    };
    this.#root.addEventListener('focusout', left, { signal });
  }
}

function report(target: Element, dispatch: Dispatch): void {
  const { handle, of, corner, ring, ringCorner } = (target as HTMLElement).dataset;
  if (handle !== undefined) dispatch({ type: 'handle-focused', id: handle });
  else if (of !== undefined) dispatch({ type: 'corner-focused', corner: { id: of, index: Number(corner) } });
  else if (ring !== undefined)
    dispatch({ type: 'ring-focused', corner: { ring: Number(ring), index: Number(ringCorner) } });
  else if (target.matches('.stage')) dispatch({ type: 'stage-focused' });
  else dispatch({ type: isField(target) ? 'field-focused' : 'control-focused' });
}
