/** The text field of a name. It commits on Enter and on leaving the field. Escape keeps the old name. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { MOST_CHARACTERS } from '../document/names';
import type { ControlName } from '../editor/effects';
import { untyped } from './untyped';

export interface NameInput {
  readonly control: ControlName;
  readonly label: string;
  readonly name: string;
  /** The id of the sentence about the typed name's fault; null if it has none. */
  readonly fault?: string | null;
  /** @param keyed by Enter. */
  given(name: string, keyed: boolean): void;
  /** By Escape. */
  ended(): void;
  /** Any change of the text. */
  typed?(name: string): void;
}

export function nameInput(field: NameInput): TemplateResult {
  const text = ({ target }: Event) => (target as HTMLInputElement).value;
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== 'Enter' && event.key !== 'Escape') return;
    event.preventDefault();
    if (event.key === 'Enter') field.given(text(event), true);
    else field.ended();
  };
  const { fault = null } = field;
  return html`<label class="field">
    <input
      type="text"
      data-control=${field.control}
      aria-label=${field.label}
      aria-invalid=${String(fault !== null)}
      aria-describedby=${fault ?? nothing}
      autocomplete="off"
      spellcheck="false"
      maxlength=${MOST_CHARACTERS}
      .value=${untyped(field.name)}
      @keydown=${onKey}
      @blur=${(event: Event) => field.given(text(event), false)}
      @change=${(event: Event) => event.stopPropagation()}
      @input=${(event: Event) => {
        event.stopPropagation();
        field.typed?.(text(event));
      }}
    />
  </label>`;
}
