/** A number of the selected handles or of a corner, to be typed or stepped. */
import { html, nothing, type TemplateResult } from 'lit';
import { DEPTHS } from '../document/handle';
import type { EditorActions, EditorModel } from './model';
import { untyped } from './untyped';

export interface FieldLook {
  readonly name: string;
  readonly label: string;
  readonly unit: string;
  readonly step: number;
  /** Decimals shown: as many as can be set by hand. */
  readonly digits: number;
  readonly least?: number;
  readonly most?: number;
  /** Asks for a keyboard with digits, which lacks a minus on some phones: the value is hardly ever negative. */
  readonly digitKeys?: boolean;
  readonly tip?: string;
}

/** What coordinates have in common. */
export const PLACE = { unit: 'px', step: 1, digits: 1, digitKeys: true } as const;

/** Limit of typed pixels and degrees: far beyond any picture. */
const MOST = 1e6;

/** A number as people write it, with a point or a comma. */
export const numberOf = (text: string): number =>
  text.trim() === '' ? Number.NaN : Number(text.trim().replace(',', '.').replace('−', '-'));

const expected = ({ label, least, most }: FieldLook): string =>
  least === undefined || most === undefined
    ? `${label} takes a number, such as 120 or −3.5.`
    : `${label} takes a number from ${least} to ${most}.`;

/** Steps per arrow key in a field. */
const STEPS: Readonly<Record<string, number>> = { ArrowUp: 1, ArrowDown: -1 };

/**
 * Commits on Enter and on leaving the field; arrow keys change every number by a step, with Shift by ten; Escape
 * restores what was there.
 *
 * @param numbers those of all that is selected: shown where they are the same.
 * @param set sets each, from its current value.
 */
export function numberField(
  look: FieldLook,
  numbers: readonly number[],
  set: (value: (now: number) => number) => void,
  model: EditorModel,
  actions: EditorActions,
): TemplateResult {
  const values = numbers.map((number) => Number(number.toFixed(look.digits)));
  const shared = values.every((value) => value === values[0]) ? String(values[0]) : '';
  const { least = -MOST, most = MOST } = look;
  const commit = (event: Event) => {
    event.stopPropagation();
    const input = event.target as HTMLInputElement;
    const value = numberOf(input.value);
    if (input.value !== shared && value >= least && value <= most) {
      set(() => value);
      return;
    }
    if (input.value.trim() !== '' && input.value !== shared) actions.refuse(expected(look));
    input.value = shared;
  };
  const onKey = (event: KeyboardEvent) => {
    const input = event.target as HTMLInputElement;
    const by = (STEPS[event.key] ?? 0) * look.step * (event.shiftKey ? 10 : 1);
    if (by !== 0) {
      event.preventDefault();
      input.dispatchEvent(new Event('change'));
      set((now) => Math.min(Math.max(now + by, least), most));
    }
    if (event.key !== 'Escape') return;
    event.preventDefault();
    input.value = shared;
    const root = input.getRootNode() as ShadowRoot;
    root.querySelector<HTMLElement>('.stage')?.focus({ preventScroll: true });
  };
  return html`<label class="field ${look.name === 'rotation' ? 'turn' : ''}" title=${look.tip ?? nothing}>
    <span class="label">${look.label}</span>
    <input
      type="text"
      role="spinbutton"
      inputmode=${look.digitKeys ? 'decimal' : nothing}
      autocomplete="off"
      name=${look.name}
      aria-valuenow=${shared || nothing}
      aria-valuemin=${look.least ?? nothing}
      aria-valuemax=${look.most ?? nothing}
      aria-label="${look.label} (${look.unit || `${DEPTHS.least} to ${DEPTHS.most}`})"
      aria-description=${look.tip ?? nothing}
      placeholder="mixed"
      .value=${untyped(shared)}
      ?disabled=${model.readonly}
      @change=${commit}
      @input=${(event: Event) => event.stopPropagation()}
      @keydown=${onKey}
    /><span class="unit" aria-hidden="true">${look.unit}</span>
  </label>`;
}
