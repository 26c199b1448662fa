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

  /** Whether a copy is one of text: in a field, or selected beside the stage and the timeline. */
  get isOnText(): boolean {
    if (this.isInField) return true;
    const text = String(getSelection()).trim();
    return text !== '' && !this.#root.activeElement?.closest('.stage, .clip-key') && !this.#isOfField(text);
  }

  /** Whether a text is the selection of a field without the focus. Nobody sees that one. */
  #isOfField(text: string): boolean {
    return [...this.#root.querySelectorAll('input')].some(
      (field) =>
        isField(field) &&
        field.value.slice(field.selectionStart ?? 0, field.selectionEnd ?? 0).trim() === text,
    );
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

  /** Focuses a handle, a corner or a key once it is rendered, or else the stage, so that keys keep working. */
  move({ handle, corner, ring, key }: FocusTarget): void {
    queueMicrotask(() => {
      const id = handle === null ? '' : CSS.escape(handle);
      const wanted = corner === null ? `[data-handle="${id}"]` : `[data-of="${id}"][data-corner="${corner}"]`;
      const outlined = ring && `[data-ring="${ring.ring}"][data-ring-corner="${ring.index}"]`;
      const keyed = key && `[data-key-of="${CSS.escape(key.handle)}"][data-time="${key.time}"]`;
      const other = outlined ?? keyed;
      const button = handle === null && !other ? null : this.#root.querySelector(other ?? wanted);
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
  const { handle, of, corner, ring, ringCorner, keyOf } = (target as HTMLElement).dataset;
  if (handle !== undefined) dispatch({ type: 'handle-focused', id: handle });
  else if (of !== undefined) dispatch({ type: 'corner-focused', corner: { id: of, index: Number(corner) } });
  else if (ring !== undefined)
    dispatch({ type: 'ring-focused', corner: { ring: Number(ring), index: Number(ringCorner) } });
  else if (keyOf !== undefined) dispatch({ type: 'key-focused' });
  else if (target.matches('.stage')) dispatch({ type: 'stage-focused' });
  else dispatch({ type: isField(target) ? 'field-focused' : 'control-focused' });
}
