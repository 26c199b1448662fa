/** The export panel: format, quality, size and area, and the button that exports. On a phone it is a sheet. */
import { html, nothing, type TemplateResult } from 'lit';
import { ariaKeys, COMMANDS, keyHint } from '../editor/commands';
import type { Dispatch, NumberChange } from '../editor/events';
import {
  EXPORT_FORMATS,
  type ExportChoices,
  type ExportFormat,
  PERCENTS,
  QUALITIES,
} from '../editor/export_choices';
import type { EditorModel } from '../editor/view_model';
import type { Area } from '../geometry/area';
import type { Size } from '../geometry/camera';
import { placeBelowButton } from './below_button';
import { closePopover } from './close_popover';
import { captionOf } from './command_button';
import { icon } from './icons';
import { type FieldLook, numberField } from './number_field';
import { segment } from './segment';

const FORMAT_NOTES: Readonly<Record<ExportFormat, string>> = {
  png: 'Every pixel as it is, with transparency.',
  jpeg: 'Small files of photographs, without transparency.',
  webp: 'Small files, with transparency.',
};

const AREAS = {
  picture: { word: 'Original', note: 'The rectangle of the original.' },
  grown: { word: 'All of it', note: 'Grown to hold the parts that are bent beyond the original.' },
  covered: { word: 'Covered', note: 'Only the covered part, without an empty border.' },
} as const satisfies Record<Area, object>;

const SIZE: FieldLook = {
  name: 'percent',
  label: 'Size',
  unit: '%',
  step: 5,
  digits: 1,
  ...PERCENTS,
  digitKeys: true,
  changesNothing: true,
};

type Choose = (choice: Partial<ExportChoices>) => void;

export function exportMenu(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const label = COMMANDS['export-as'].label;
  const choose: Choose = (choice) => dispatch({ type: 'export-choice-made', choice });
  return html`<div class="menu">
    <button
      type="button"
      class="button worded"
      part="button"
      popovertarget="export"
      data-tip=${label}
      data-keys=${keyHint('export-as', model.platform)}
      aria-label=${label}
      aria-keyshortcuts=${ariaKeys('export-as', model.platform) || nothing}
      ?disabled=${!model.canRun('export')}
    >
      ${icon('export')}<span class="word">Export</span>${captionOf('Export')}
    </button>
    <div
      id="export"
      class="popover card export"
      part="menu"
      popover
      role="dialog"
      aria-label="Export"
      tabindex="-1"
      @beforetoggle=${(event: ToggleEvent) => {
        placeBelowButton(event);
        dispatch({ type: 'popover-toggled', popover: 'export', open: event.newState === 'open' });
      }}
    >
      ${choices(model, choose, dispatch)}
      <div class="row">
        <span class="faint">${sizeText(model.exporting.size, model.exporting.choices.area)}</span>
        ${exportButton(model, dispatch)}
      </div>
    </div>
  </div>`;
}

/** Opens the panel for the keyboard, so that Enter exports; or closes it. */
export function toggleExport(root: ShadowRoot): void {
  const panel = root.querySelector<HTMLElement>('#export');
  panel?.togglePopover();
  if (panel?.matches(':popover-open')) panel.querySelector<HTMLElement>('.primary')?.focus();
}

function choices(model: EditorModel, choose: Choose, dispatch: Dispatch): TemplateResult {
  const { choices } = model.exporting;
  const formats = Object.keys(EXPORT_FORMATS) as ExportFormat[];
  return html`<div class="segments" role="group" aria-label="Format">
      ${formats.map((format) => segment(EXPORT_FORMATS[format].name, format === choices.format, false, () => choose({ format })))}
    </div>
    <p class="faint">${FORMAT_NOTES[choices.format]}</p>
    ${choices.format === 'png' ? nothing : quality(choices, choose)}
    ${choices.format === 'jpeg' ? background(choices, choose) : nothing}
    <div class="segments" role="group" aria-label="Area">
      ${(Object.keys(AREAS) as Area[]).map((area) => segment(AREAS[area].word, area === choices.area, false, () => choose({ area })))}
    </div>
    <p class="faint">${AREAS[choices.area].note}</p>
    ${numberField(SIZE, [choices.percent], (change) => choose({ percent: changed(choices.percent, change) }), model, dispatch)}`;
}

function changed(value: number, change: NumberChange): number {
  return 'to' in change ? change.to : Math.min(change.most, Math.max(change.least, value + change.by));
}

/** The value of an input, kept from the page: it is no edit of the document. */
function keptValue(event: Event): string {
  event.stopPropagation();
  return (event.target as HTMLInputElement).value;
}

const quality = ({ quality }: ExportChoices, choose: Choose): TemplateResult => html`<label class="option">
  <span>Quality</span>
  <input
    type="range"
    name="quality"
    aria-label="Quality"
    min=${QUALITIES.least}
    max=${QUALITIES.most}
    .value=${String(quality)}
    @input=${(event: Event) => choose({ quality: Number(keptValue(event)) })}
    @change=${keptValue}
  />
  <output>${quality}</output>
</label>`;

const background = (
  { background }: ExportChoices,
  choose: Choose,
): TemplateResult => html`<label class="option">
  <span>Background</span>
  <input
    type="color"
    name="background"
    aria-label="Background"
    .value=${background}
    @input=${(event: Event) => choose({ background: keptValue(event) })}
    @change=${keptValue}
  />
</label>`;

/** The size of a grown or covered area is that of the posed mesh, which soft edges change by a few pixels. */
function sizeText(size: Size | null, area: Area): string {
  if (!size) return '';
  const [width, height] = [size.width, size.height].map((side) => side.toLocaleString('en'));
  return `${area === 'picture' ? '' : '≈ '}${width} × ${height} px`;
}

function exportButton(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { choices, running } = model.exporting;
  return html`<button
    type="button"
    class="primary"
    part="button"
    ?disabled=${running}
    @click=${(event: Event) => {
      // Before the export disables the button, which would keep the focus.
      closePopover(event);
      dispatch({ type: 'command-run', command: 'export' });
    }}
  >
    Export ${EXPORT_FORMATS[choices.format].name}
  </button>`;
}
