/** The property panel: the numbers of what is selected, and the list of all handles. A sheet on a phone. */
import { html, nothing, type TemplateResult } from 'lit';
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
import { bending } from './bending';
import type { EditorActions, EditorModel, Field } from './model';
import { commandButton } from './toolbar';
import { untyped } from './untyped';

interface FieldLook {
  readonly field: Field;
  readonly label: string;
  readonly name: string;
  readonly unit: string;
  readonly step: number;
  /** Decimals shown: as many as one can set by hand. */
  readonly digits: number;
  readonly least?: number;
  readonly most?: number;
  readonly tip?: string;
  read(handle: Handle, turns: Turns): number;
}

const FIELDS: readonly FieldLook[] = [
  { field: 'x', label: 'X', name: 'x', unit: 'px', step: 1, digits: 1, read: (handle) => anchor(handle)[0] },
  { field: 'y', label: 'Y', name: 'y', unit: 'px', step: 1, digits: 1, read: (handle) => anchor(handle)[1] },
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

/** Pixels and degrees that can be typed: far beyond any picture. */
const MOST = 1e6;

export function panel(model: EditorModel, actions: EditorActions): TemplateResult {
  const selected = selectedHandles(model.document);
  return html`<section
    class="panel card ${selected.length > 0 || model.settings ? 'open' : ''}"
    part="panel"
    aria-label="Properties"
  >
    ${selected.length > 0 ? properties(selected, model, actions) : bending(model, actions)}
    ${handleList(model, actions)}
  </section>`;
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
      ${commandButton('reset', model, actions, { enabled: !model.readonly && moved, label: 'Reset to rest' })}
      ${commandButton('remove', model, actions, { enabled: !model.readonly })}
    </div>
  </section>`;
}

const cornersRow = ({ posed }: LineHandle, model: EditorModel, actions: EditorActions): TemplateResult =>
  html`<div class="row">
    <span
      class="faint"
      title="Double-click the line for one more there, a corner to delete it"
      >${posed.length} corners: double-click adds or deletes one</span
    >
    ${commandButton('add-corner', model, actions, { enabled: !model.readonly })}
  </div>`;

/** A field, with the buttons that belong to it. */
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

/** Commits on Enter, on leaving the field and on its arrow keys; Escape puts the old number back. */
function numberField(
  look: FieldLook,
  selected: readonly Handle[],
  model: EditorModel,
  actions: EditorActions,
): TemplateResult {
  const values = selected.map((handle) => Number(look.read(handle, model.turns).toFixed(look.digits)));
  const shared = values.every((value) => value === values[0]) ? String(values[0]) : '';
  const commit = (event: Event) => {
    event.stopPropagation();
    const input = event.target as HTMLInputElement;
    const value = input.valueAsNumber;
    const { least = -MOST, most = MOST } = look;
    if (value >= least && value <= most) {
      actions.field(look.field, value);
    } else {
      input.value = shared;
    }
  };
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== 'Escape') return;
    const input = event.target as HTMLInputElement;
    input.value = shared;
    const root = input.getRootNode() as ShadowRoot;
    root.querySelector<HTMLElement>('.shell')?.focus({ preventScroll: true });
  };
  return html`<label class="field ${look.field === 'rotation' ? 'turn' : ''}" title=${look.tip ?? nothing}>
    <span class="label">${look.label}</span>
    <input
      type="number"
      name=${look.name}
      step=${look.step}
      aria-label="${look.name} (${look.unit || `${DEPTHS.least} to ${DEPTHS.most}`})"
      placeholder="mixed"
      .value=${untyped(shared)}
      ?disabled=${model.disabled || model.readonly}
      @change=${commit}
      @input=${(event: Event) => event.stopPropagation()}
      @keydown=${onKey}
    /><span class="unit" aria-hidden="true">${look.unit}</span>
  </label>`;
}

/** Whether what is selected turns by itself. Among several that differ, a press frees them all. */
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
    ?disabled=${model.disabled || model.readonly}
    @click=${() => actions.automatic(!all)}
  >
    Auto
  </button>`;
}

/** A press takes hold of the handle itself, so that arrow keys move it; the keyboard stays in the list. */
function listed(event: MouseEvent, id: string, actions: EditorActions): void {
  actions.select([id]);
  if (event.detail > 0) actions.hold(id);
}

function handleList(model: EditorModel, actions: EditorActions): TemplateResult {
  const { project, selection } = model.document;
  return html`<section class="list">
    <h3>Handles <span class="faint">${project.handles.length}</span></h3>
    ${
      project.handles.length === 0
        ? html`<p class="faint">None yet. Choose the point tool (P) and click the picture, or draw a bar (B) or a polygon (G).</p>`
        : html`<ul>
            ${project.handles.map(
              (handle) => html`<li>
                <button
                  type="button"
                  class="item"
                  aria-pressed=${String(selection.includes(handle.id))}
                  ?disabled=${model.disabled}
                  @click=${(event: MouseEvent) =>
                    event.shiftKey ? actions.toggle(handle.id) : listed(event, handle.id, actions)}
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
