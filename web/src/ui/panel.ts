/**
 * The property panel: the numbers of the selected handles, how the picture bends, and the list of all handles.
 *
 * On a phone it is a sheet with one of the first two. For selected handles the sheet shows one line, and the numbers at
 * a press; it keeps clear of the selected handles, and is hidden during a drag.
 */
import { html, nothing, type TemplateResult } from 'lit';
import { classMap } from 'lit/directives/class-map.js';
import { selectedHandles } from '../document/document';
import {
  anchor,
  DEPTHS,
  depthOf,
  isAtRest,
  isAutomatic,
  isLine,
  nameOf,
  rotationOf,
  scaleOf,
  type Turns,
} from '../document/handle';
import type { Handle, LineHandle } from '../document/project';
import { toStage } from '../geometry/camera';
import { centre } from '../geometry/polyline';
import { bending } from './bending';
import { icon } from './icons';
import type { EditorActions, EditorModel, Field } from './model';
import { commandButton } from './toolbar';
import { untyped } from './untyped';

interface FieldLook {
  readonly field: Field;
  readonly label: string;
  readonly name: string;
  readonly unit: string;
  readonly step: number;
  /** Decimals shown: as many as can be set by hand. */
  readonly digits: number;
  readonly least?: number;
  readonly most?: number;
  /** Asks for a keyboard with digits, which lacks a minus on some phones: the value is hardly ever negative. */
  readonly digitKeys?: boolean;
  readonly tip?: string;
  read(handle: Handle, turns: Turns): number;
}

const FIELDS: readonly FieldLook[] = [
  {
    field: 'x',
    label: 'X',
    name: 'x',
    unit: 'px',
    step: 1,
    digits: 1,
    digitKeys: true,
    read: (handle) => anchor(handle)[0],
  },
  {
    field: 'y',
    label: 'Y',
    name: 'y',
    unit: 'px',
    step: 1,
    digits: 1,
    digitKeys: true,
    read: (handle) => anchor(handle)[1],
  },
  { field: 'rotation', label: 'Turn', name: 'rotation', unit: '°', step: 1, digits: 1, read: rotationOf },
  {
    field: 'scale',
    label: 'Scale',
    name: 'scale',
    unit: '×',
    step: 0.05,
    digits: 2,
    least: 0.01,
    most: 100,
    digitKeys: true,
    read: scaleOf,
  },
  {
    field: 'depth',
    label: 'Depth',
    name: 'depth',
    unit: '',
    step: 1,
    digits: 2,
    tip: `What lies over what, from ${DEPTHS.least} at the back to ${DEPTHS.most} in front`,
    read: depthOf,
  },
];

/** Limit of typed pixels and degrees: far beyond any picture. */
const MOST = 1e6;

export function panel(model: EditorModel, actions: EditorActions): TemplateResult {
  const selected = selectedHandles(model.document);
  const { settings, numbers, pressing } = model;
  const looks = {
    open: selected.length > 0 || settings,
    settings,
    numbers,
    away: pressing && !settings,
    high: !settings && isLow(selected, model),
  };
  return html`<section class="panel card ${classMap(looks)}" part="panel" aria-label="Properties">
    ${selected.length > 0 ? properties(selected, model, actions) : nothing}
    ${bending(model, actions, selected.length === 0 || settings)} ${handleList(model, actions)}
  </section>`;
}

/** Height of the sheet with one line, from the bottom of the stage, with room for a handle's dot above. CSS pixels. */
const LINE_SHEET = 150;

/** Whether the centre of the selection lies where the sheet would: with numbers, in the lower half of the stage. */
function isLow(selected: readonly Handle[], { camera, stage: { height }, numbers }: EditorModel): boolean {
  if (selected.length === 0) return false;
  const [, y] = toStage(camera, centre(selected.map((handle) => anchor(handle))));
  return y > (numbers ? height / 2 : Math.max(height / 2, height - LINE_SHEET));
}

function properties(selected: readonly Handle[], model: EditorModel, actions: EditorActions): TemplateResult {
  const [first] = selected;
  if (!first) return html``;
  const title = selected.length === 1 ? nameOf(first) : `${selected.length} handles`;
  const rest = anchor(first, 'rest').map((value) => Math.round(value));
  const moved = selected.some((handle) => !isAtRest(handle));
  return html`<section class="properties" aria-label="Selected handle">
    <h2>${title}</h2>
    <div class="fields">
      ${FIELDS.map((look) =>
        besides(look, numberField(look, selected, model, actions), selected, model, actions),
      )}
    </div>
    ${selected.length === 1 && isLine(first) ? cornersRow(first, model, actions) : nothing}
    <div class="row">
      <span class="faint">${selected.length === 1 ? `Rests at ${rest.join(', ')}` : ''}</span>
      <button
        type="button"
        class="button unfold"
        part="button"
        aria-label="Numbers"
        aria-expanded=${String(model.numbers)}
        @click=${() => actions.numbers(!model.numbers)}
      >
        ${icon('unfold')}
      </button>
      ${commandButton('reset', model, actions, { enabled: !model.readonly && moved, label: 'Reset to rest' })}
      ${commandButton('remove', model, actions, { enabled: !model.readonly })}
    </div>
  </section>`;
}

const cornersRow = ({ posed }: LineHandle, model: EditorModel, actions: EditorActions): TemplateResult =>
  html`<div class="row corners">
    <span
      class="faint"
      title="Double-${model.press} the line for one more there, a corner to delete it"
      >${posed.length} corners: double-${model.press} adds or deletes one</span
    >
    ${commandButton('add-corner', model, actions, { enabled: !model.readonly })}
  </div>`;

/** A field with its buttons. */
function besides(
  { field }: FieldLook,
  input: TemplateResult,
  selected: readonly Handle[],
  model: EditorModel,
  actions: EditorActions,
): TemplateResult {
  if (field === 'rotation' && selected.some((handle) => !isLine(handle))) {
    return html`<div class="pair turn">${input} ${automaticToggle(selected, model, actions)}</div>`;
  }
  if (field !== 'depth') return input;
  const enabled = (end: number) => !model.readonly && selected.some((handle) => depthOf(handle) !== end);
  return html`<div class="pair depth">
    ${input} ${commandButton('backward', model, actions, { enabled: enabled(DEPTHS.least) })}
    ${commandButton('forward', model, actions, { enabled: enabled(DEPTHS.most) })}
  </div>`;
}

/** A number as people write it, with a point or a comma. */
const numberOf = (text: string): number =>
  text.trim() === '' ? Number.NaN : Number(text.trim().replace(',', '.').replace('−', '-'));

const expected = ({ label, least, most }: FieldLook): string =>
  least === undefined || most === undefined
    ? `${label} takes a number, such as 120 or −3.5.`
    : `${label} takes a number from ${least} to ${most}.`;

/** Steps per arrow key in a field. */
const STEPS: Readonly<Record<string, number>> = { ArrowUp: 1, ArrowDown: -1 };

/**
 * Commits on Enter and on leaving the field; arrow keys change every selected handle by a step, with Shift by ten;
 * Escape restores the old number.
 */
function numberField(
  look: FieldLook,
  selected: readonly Handle[],
  model: EditorModel,
  actions: EditorActions,
): TemplateResult {
  const values = selected.map((handle) => Number(look.read(handle, model.turns).toFixed(look.digits)));
  const shared = values.every((value) => value === values[0]) ? String(values[0]) : '';
  const { least = -MOST, most = MOST } = look;
  const commit = (event: Event) => {
    event.stopPropagation();
    const input = event.target as HTMLInputElement;
    const value = numberOf(input.value);
    if (input.value !== shared && value >= least && value <= most) {
      actions.field(look.field, () => value);
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
      actions.field(look.field, (now) => Math.min(Math.max(now + by, least), most));
    }
    if (event.key !== 'Escape') return;
    event.preventDefault();
    input.value = shared;
    const root = input.getRootNode() as ShadowRoot;
    root.querySelector<HTMLElement>('.shell')?.focus({ preventScroll: true });
  };
  return html`<label class="field ${look.field === 'rotation' ? 'turn' : ''}" title=${look.tip ?? nothing}>
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
      aria-label="${look.name} (${look.unit || `${DEPTHS.least} to ${DEPTHS.most}`})"
      placeholder="mixed"
      .value=${untyped(shared)}
      ?disabled=${model.readonly}
      @change=${commit}
      @input=${(event: Event) => event.stopPropagation()}
      @keydown=${onKey}
    /><span class="unit" aria-hidden="true">${look.unit}</span>
  </label>`;
}

/** Whether the selected points turn automatically. Where they differ, a press makes all of them automatic. */
function automaticToggle(
  selected: readonly Handle[],
  model: EditorModel,
  actions: EditorActions,
): TemplateResult {
  const points = selected.filter((handle) => !isLine(handle));
  const free = points.filter(isAutomatic).length;
  const all = free === points.length;
  return html`<button
    type="button"
    class="button toggle"
    part="button"
    data-tip=${all ? 'Turns with what is around it' : 'Let it turn by itself'}
    aria-label="Automatic turn"
    aria-pressed=${all ? 'true' : free > 0 ? 'mixed' : 'false'}
    ?disabled=${model.readonly}
    @click=${() => actions.automatic(!all)}
  >
    Auto
  </button>`;
}

/** Selects a handle and brings it into view. A press also focuses it, for arrow keys; the keyboard stays in the list. */
function listed(event: MouseEvent, handle: Handle, actions: EditorActions): void {
  actions.select([handle.id]);
  actions.reveal(anchor(handle));
  if (event.detail > 0) actions.hold(handle.id);
}

/** Whether a press adds to the selection, or removes from it. */
const adds = (event: MouseEvent): boolean => event.shiftKey || event.ctrlKey || event.metaKey;

function handleList(model: EditorModel, actions: EditorActions): TemplateResult {
  const { project, selection } = model.document;
  return html`<section class="list">
    <h3>Handles <span class="faint">${project.handles.length}</span></h3>
    ${
      project.handles.length === 0
        ? html`<p class="faint">None yet. Choose the point tool (P) and ${model.press} the picture, or draw a bar (B) or a polygon (G).</p>`
        : html`<ul>
            ${project.handles.map(
              (handle) => html`<li>
                <button
                  type="button"
                  class="item"
                  aria-pressed=${String(selection.includes(handle.id))}
                  @click=${(event: MouseEvent) =>
                    adds(event) ? actions.toggle(handle.id) : listed(event, handle, actions)}
                >
                  <span class="dot of-${handle.kind}"></span><span class="name">${nameOf(handle)}</span>
                  ${isAtRest(handle) ? nothing : html`<span class="moved" title="Moved from its rest"></span>`}
                </button>
              </li>`,
            )}
          </ul>`
    }
  </section>`;
}

/** Scrolls the list, and nothing else, to the first selected handle. */
export function showSelected(root: ShadowRoot): void {
  const list = root.querySelector('.list ul');
  const item = list?.querySelector('[aria-pressed="true"]');
  if (!list || !item) return;
  const [frame, box] = [list.getBoundingClientRect(), item.getBoundingClientRect()];
  list.scrollTop += Math.min(0, box.top - frame.top) + Math.max(0, box.bottom - frame.bottom);
}
