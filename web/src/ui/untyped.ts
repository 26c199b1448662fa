/** A field's value as the editor knows it, without taking away what a person is typing. */
import { noChange } from 'lit';
import { Directive, directive, type PropertyPart } from 'lit/directive.js';

/** Fields with something typed into them that is neither committed nor left. */
const typed = new WeakSet<EventTarget>();

export const isTyped = (field: EventTarget): boolean => typed.has(field);

class Untyped extends Directive {
  #listening = false;

  override render(value: string): string {
    return value;
  }

  override update({ element }: PropertyPart, [value]: [string]): string | typeof noChange {
    const input = element as HTMLInputElement;
    if (!this.#listening) this.#listen(input);
    // Set here: Lit compares with what it set last, not with what a person has put there since.
    if (!isTyped(input) && input.value !== value) input.value = value;
    return noChange;
  }

  /** Before the field's own listeners: what they change may be shown at once. */
  #listen(input: HTMLInputElement): void {
    this.#listening = true;
    const over = () => typed.delete(input);
    input.addEventListener('input', () => typed.add(input), { capture: true });
    input.addEventListener('change', over, { capture: true });
    input.addEventListener('blur', over, { capture: true });
  }
}

/** For `.value=` of an input: the value, except from the first key typed into it until that is committed or left. */
export const untyped = directive(Untyped);
