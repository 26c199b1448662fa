/** A field's value as the editor knows it, without taking away what a person is typing. */
import { noChange } from 'lit';
import { Directive, directive, type PropertyPart } from 'lit/directive.js';

class Untyped extends Directive {
  #typing: boolean | undefined;

  override render(value: string): string {
    return value;
  }

  override update({ element }: PropertyPart, [value]: [string]): string | typeof noChange {
    const input = element as HTMLInputElement;
    if (this.#typing === undefined) this.#listen(input);
    // Set here: Lit compares with what it set last, not with what a person has put there since.
    if (!this.#typing && input.value !== value) input.value = value;
    return noChange;
  }

  /** Before the field's own listeners: what they change may be shown at once. */
  #listen(input: HTMLInputElement): void {
    this.#typing = false;
    const typing = (now: boolean) => () => {
      this.#typing = now;
    };
    input.addEventListener('input', typing(true), { capture: true });
    input.addEventListener('change', typing(false), { capture: true });
    input.addEventListener('blur', typing(false), { capture: true });
  }
}

/** For `.value=` of an input: the value, except from the first key typed into it until that is committed or left. */
export const untyped = directive(Untyped);
