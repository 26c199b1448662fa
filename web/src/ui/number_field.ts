/** A number of the selected handles or of a corner, to be typed or stepped. */

import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch, NumberChange } from '../editor/events';
import { typedNumber } from '../editor/typed_number';
import type { EditorModel } from '../editor/view_model';
import { say, type Wording } from '../texts/wording';
import { untyped } from './untyped';

export interface FieldLook {
  readonly name: string;
  readonly label: string;
  readonly unit: string;
  readonly step: number;
  /** Number of decimals shown, the same as people can set. */
  readonly digits: number;
  readonly least?: number;
  readonly most?: number;
  /** Asks for a keyboard with digits, which lacks a minus on some phones. For values that are hardly ever negative. */
  readonly digitKeys?: boolean;
  readonly tip?: string;
  /** The number is no part of the document, so that it can also be set by people who may change nothing. */
  readonly changesNothing?: true;
}

/** The common look of coordinates. */
export const PLACE = { unit: 'px', step: 1, digits: 1, digitKeys: true } as const;

/** Limit of typed pixels and degrees, far beyond any picture. */
const MOST = 1e6;

const expected = ({ label, least, most }: FieldLook, value: number): Wording => {
  if (least !== undefined && most !== undefined) return say('panel.takesRange', label, least, most);
  return Number.isNaN(value) ? say('panel.takesNumber', label) : say('panel.takesUpTo', label, MOST);
};

/** The press that focuses the field selects its number, to be typed over. The next one sets the caret. */
function selectAll(event: MouseEvent): void {
  const input = event.currentTarget as HTMLInputElement;
  if ((input.getRootNode() as ShadowRoot).activeElement === input) return;
  event.preventDefault();
  input.focus();
  input.select();
}

/** Steps per arrow key in a field. */
const STEPS: Readonly<Record<string, number>> = { ArrowUp: 1, ArrowDown: -1 };

/**
 * Commits on Enter and on leaving the field. Arrow keys change every number by a step, with Shift by ten. Escape
 * restores the old number.
 *
 * @param numbers the numbers of all selected handles, shown if they are equal.
 * @param set sets the number of each selected handle.
 */
export function numberField(
  look: FieldLook,
  numbers: readonly number[],
  set: (change: NumberChange) => void,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const values = numbers.map((number) => Number(number.toFixed(look.digits)));
  const shared = values.every((value) => value === values[0]) ? String(values[0]) : '';
  const { least = -MOST, most = MOST } = look;
  const { panel: words } = model.texts;
  const commit = (event: Event) => {
    event.stopPropagation();
    const input = event.target as HTMLInputElement;
    const value = typedNumber(input.value);
    if (input.value !== shared && value >= least && value <= most) {
      set({ to: value });
      return;
    }
    if (input.value.trim() !== '' && input.value !== shared)
      dispatch({ type: 'number-refused', text: expected(look, value) });
    input.value = shared;
  };
  const onKey = (event: KeyboardEvent) => {
    const input = event.target as HTMLInputElement;
    const by = (STEPS[event.key] ?? 0) * look.step * (event.shiftKey ? 10 : 1);
    if (by !== 0) {
      event.preventDefault();
      input.dispatchEvent(new Event('change'));
      set({ by, least, most });
    }
    if (event.key !== 'Escape') return;
    const popover = input.closest('[popover]');
    // Closes the popover.
    if (popover && input.value === shared) return;
    event.preventDefault();
    input.value = shared;
    const root = input.getRootNode() as ShadowRoot;
    if (!popover) root.querySelector<HTMLElement>('.stage')?.focus({ preventScroll: true });
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
      aria-label=${words.numberLabel(look.label, look.unit || words.range(look.least ?? 0, look.most ?? 0))}
      aria-description=${look.tip ?? nothing}
      placeholder=${words.mixed}
      .value=${untyped(shared)}
      ?disabled=${model.readonly && !look.changesNothing}
      @change=${commit}
      @input=${(event: Event) => event.stopPropagation()}
      @keydown=${onKey}
      @mousedown=${selectAll}
    /><span class="unit" aria-hidden="true">${look.unit}</span>
  </label>`;
}
