/** Binds a field to a value without overwriting text that a person is typing. */
import { noChange } from 'lit-html';
import { Directive, directive, type PropertyPart } from 'lit-html/directive.js';

/** Whether an element is a text field. Those of numbers are too. */
export const isField = (element: Element | null): boolean =>
  element?.matches('input:is([type=text], [type=url])') === true;

/** Fields with typed text that is not committed yet. */
const typed = new WeakSet<EventTarget>();

export const isTyped = (field: EventTarget): boolean => typed.has(field);

/** The value that each field is bound to. */
const bound = new WeakMap<EventTarget, string>();

/** Replaces typed text by the bound value. */
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
    // Set here, because Lit compares with the value that it set last, not with the typed text.
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

/** For `.value=` of an input. Sets the value, except between the first typed key and commit or blur. */
export const untyped = directive(Untyped);
