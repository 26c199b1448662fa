/** Binds a field to its value in the editor without overwriting what a person is typing. */
import { noChange } from 'lit';
import { Directive, directive, type PropertyPart } from 'lit/directive.js';

/** Whether an element is a field that text is typed into. */
export const isField = (element: Element | null): boolean =>
  element?.matches('input:not([type=checkbox])') === true;

/** Fields with typed text that is not committed yet, and not left. */
const typed = new WeakSet<EventTarget>();

export const isTyped = (field: EventTarget): boolean => typed.has(field);

/** What each field is bound to. */
const bound = new WeakMap<EventTarget, string>();

/** Puts back what a field is bound to, in place of what is being typed. */
export function untype(field: HTMLInputElement): void {
  typed.delete(field);
  field.value = bound.get(field) ?? field.value;
}

class Untyped extends Directive {
  #listening = false;

  override render(value: string): string {
    return value;
  }

  override update({ element }: PropertyPart, [value]: [string]): string | typeof noChange {
    const input = element as HTMLInputElement;
    if (!this.#listening) this.#listen(input);
    bound.set(input, value);
    // Set here: Lit compares with the value it set last, not with what was typed since.
    if (!isTyped(input) && input.value !== value) input.value = value;
    return noChange;
  }

  /** Captures events before the field's own listeners, whose changes may be rendered at once. */
  #listen(input: HTMLInputElement): void {
    this.#listening = true;
    const over = () => typed.delete(input);
    input.addEventListener('input', () => typed.add(input), { capture: true });
    input.addEventListener('change', over, { capture: true });
    input.addEventListener('blur', over, { capture: true });
  }
}

/** For `.value=` of an input: sets the value, except between the first typed key and commit or blur. */
export const untyped = directive(Untyped);
