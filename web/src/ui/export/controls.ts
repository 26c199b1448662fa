/** Controls that exports of all kinds have. */

import { html, type TemplateResult } from 'lit-html';
import type { Dispatch, NumberChange } from '../../editor/events';
import { PERCENTS, QUALITIES } from '../../editor/export_choices';
import type { EditorModel } from '../../editor/view_model';
import type { Size } from '../../geometry/camera';
import type { Texts } from '../../texts/texts';
import { closePopover } from '../close_popover';
import type { FieldLook } from '../number_field';
import { segment } from '../segment';

export const sizeLook = ({ exporting }: Texts): FieldLook => ({
  name: 'percent',
  label: exporting.size,
  unit: '%',
  step: 5,
  digits: 1,
  ...PERCENTS,
  digitKeys: true,
  changesNothing: true,
});

export function changed(value: number, change: NumberChange): number {
  return 'to' in change ? change.to : Math.min(change.most, Math.max(change.least, value + change.by));
}

/** A choice among a few words. `lacking` ones cannot be chosen. */
export const choice = <T extends string>(
  label: string,
  words: Readonly<Partial<Record<T, string>>>,
  chosen: T | null,
  choose: (value: T) => void,
  lacking: readonly T[] = [],
): TemplateResult => html`<div class="segments" role="group" aria-label=${label}>
  ${(Object.keys(words) as T[]).map((value) =>
    segment(words[value] ?? value, value === chosen, lacking.includes(value), () => choose(value)),
  )}
</div>`;

/** The value of an input, kept from the page: it is no edit of the document. */
export function keptValue(event: Event): string {
  event.stopPropagation();
  return (event.target as HTMLInputElement).value;
}

export const qualityOption = (
  quality: number,
  { exporting }: Texts,
  choose: (quality: number) => void,
): TemplateResult => html`<label class="option">
  <span>${exporting.quality}</span>
  <input
    type="range"
    name="quality"
    aria-label=${exporting.quality}
    min=${QUALITIES.least}
    max=${QUALITIES.most}
    .value=${String(quality)}
    @input=${(event: Event) => choose(Number(keptValue(event)))}
    @change=${keptValue}
  />
  <output>${quality}</output>
</label>`;

export const colourOption = (
  label: string,
  name: string,
  colour: string,
  choose: (colour: string) => void,
): TemplateResult => html`<label class="option">
  <span>${label}</span>
  <input
    type="color"
    name=${name}
    aria-label=${label}
    .value=${colour}
    @input=${(event: Event) => choose(keptValue(event))}
    @change=${keptValue}
  />
</label>`;

/** @param about the size of the posed mesh, which soft edges change by a few pixels. */
export function sizeText(size: Size | null, about: boolean, { exporting }: Texts): string {
  if (!size) return '';
  const { width, height } = size;
  return about ? exporting.aboutPixels(width, height) : exporting.pixels(width, height);
}

/** The last row: a text about the file, and the button with its label. */
export const exportRow = (
  summary: string | TemplateResult,
  label: string,
  disabled: boolean,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult => html`<div class="row">
  <span class="faint">${summary}</span>
  <button
    type="button"
    class="primary"
    part="button"
    ?disabled=${disabled || model.exporting.running}
    @click=${(event: Event) => {
      // Before the export disables the button, which would keep the focus.
      closePopover(event);
      dispatch({ type: 'command-run', command: 'export' });
    }}
  >
    ${label}
  </button>
</div>`;
