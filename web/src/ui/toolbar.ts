/** The bar of documents and history at the top, and the strip of tools beside the picture (below it on a phone). */
import { html, nothing, type TemplateResult } from 'lit';
import type { ToolName } from '../tools/machine';
import { ariaKeys, COMMANDS, type CommandName, keyHint } from './commands';
import { icon } from './icons';
import type { EditorActions, EditorModel, OverlayFlags } from './model';

interface Look {
  readonly text?: string;
  readonly enabled?: boolean;
  readonly pressed?: boolean;
  /** A fuller label than the table's: "Undo move head". */
  readonly label?: string;
}

/** A button that runs a command, with the table's label, icon and keys. */
export function commandButton(
  name: CommandName,
  model: EditorModel,
  actions: EditorActions,
  look: Look = {},
): TemplateResult {
  const label = look.label ?? COMMANDS[name].label;
  return html`<button
    type="button"
    class="button ${look.text ? 'worded' : ''}"
    part="button"
    data-command=${name}
    data-tip=${label}
    data-keys=${keyHint(name, model.platform)}
    aria-label=${label}
    aria-keyshortcuts=${ariaKeys(name) || nothing}
    aria-pressed=${look.pressed === undefined ? nothing : String(look.pressed)}
    ?disabled=${look.enabled === false}
    @click=${() => actions.run(name)}
  >
    ${icon(COMMANDS[name].icon)}${look.text ? html`<span class="word">${look.text}</span>` : ''}
  </button>`;
}

export function topBar(model: EditorModel, actions: EditorActions): TemplateResult {
  const editable = !model.readonly && model.picture !== null;
  const { handles } = model.document.project;
  const command = (name: CommandName, look?: Look) => commandButton(name, model, actions, look);
  return html`<div class="top" part="toolbar" role="group" aria-label="Document">
    <span class="brand" aria-hidden="true">c<sup>2</sup>warp</span>
    <div class="group">
      ${command('open', { text: 'Open', enabled: !model.readonly })}
      ${command('save', { text: 'Save', enabled: model.picture !== null })}
      ${command('export', { text: 'Export', enabled: model.picture !== null })}
    </div>
    <div class="group">
      ${command('undo', { enabled: editable && model.undo !== null, label: told('Undo', model.undo) })}
      ${command('redo', { enabled: editable && model.redo !== null, label: told('Redo', model.redo) })}
    </div>
    <div class="group">
      ${command('reset-all', { enabled: editable && handles.length > 0 })}
      ${compareButton(model, actions)} ${overlayMenu(model, actions)}
    </div>
    <span class="title" title=${model.picture?.name ?? ''}>${model.picture?.name ?? ''}</span>
    ${themeButton(model, actions)}
  </div>`;
}

const told = (verb: string, label: string | null): string =>
  label === null ? verb : `${verb}: ${label.charAt(0).toLowerCase()}${label.slice(1)}`;

const TOOL_ORDER: readonly ToolName[] = ['select', 'point', 'bar', 'polygon', 'hand'];

export function toolStrip(model: EditorModel, actions: EditorActions): TemplateResult {
  return html`<div class="tools card" part="tools" role="group" aria-label="Tools">
    ${TOOL_ORDER.map((name) =>
      commandButton(name, model, actions, {
        pressed: model.tool === name,
        enabled: name === 'hand' || !model.readonly,
      }),
    )}
    <span class="sheet-switch">
      ${commandButton('settings', model, actions, {
        pressed: model.settings,
        enabled: model.picture !== null,
      })}
    </span>
  </div>`;
}

/** Shows the original while it is held, by pointer or key; a click without a press, as of a screen reader, toggles. */
function compareButton(model: EditorModel, actions: EditorActions): TemplateResult {
  const hold = () => actions.compare(true);
  const release = () => actions.compare(false);
  const onKey = (event: KeyboardEvent, act: () => void) => {
    if (event.key !== ' ' && event.key !== 'Enter') return;
    event.preventDefault();
    act();
  };
  return html`<button
    type="button"
    class="button"
    part="button"
    data-command="compare"
    data-tip=${COMMANDS.compare.label}
    data-keys=${keyHint('compare', model.platform)}
    aria-label=${COMMANDS.compare.label}
    aria-keyshortcuts=${ariaKeys('compare')}
    aria-pressed=${String(model.comparing)}
    ?disabled=${model.picture === null}
    @pointerdown=${hold}
    @pointerup=${release}
    @pointerleave=${release}
    @pointercancel=${release}
    @keydown=${(event: KeyboardEvent) => onKey(event, hold)}
    @keyup=${(event: KeyboardEvent) => onKey(event, release)}
    @blur=${release}
    @click=${(event: MouseEvent) => event.detail === 0 && actions.run('compare')}
    @contextmenu=${(event: Event) => event.preventDefault()}
  >
    ${icon('compare')}
  </button>`;
}

/** The name of each overlay, and what it shows. */
const OVERLAYS = {
  mesh: ['Mesh', 'The triangles that the picture is drawn with'],
  sites: ['Virtual handles', 'What moves the picture between your handles'],
  graph: ['Cell graph', 'Which handles, virtual ones too, are neighbours'],
  folds: ['Folds', 'Where the picture has turned over'],
  reach: ['Reach', 'How much of a small move of the selected handles each place of the picture follows'],
} as const satisfies Record<keyof OverlayFlags, readonly [label: string, tip: string]>;

function overlayMenu(model: EditorModel, actions: EditorActions): TemplateResult {
  const names = Object.keys(OVERLAYS) as (keyof OverlayFlags)[];
  const shown = names.some((name) => model.overlays[name]);
  return html`<div class="menu">
    <button
      type="button"
      class="button"
      part="button"
      id="overlays-button"
      popovertarget="overlays"
      data-tip="Overlays"
      aria-label="Overlays"
      aria-pressed=${String(shown)}
    >
      ${icon('overlays')}
    </button>
    <div
      id="overlays"
      class="popover card"
      popover
      aria-label="Overlays"
      role="group"
      @beforetoggle=${placeBelowButton}
    >
      ${names.map(
        (name) => html`<label class="check" title=${OVERLAYS[name][1]}>
          <input
            type="checkbox"
            aria-description=${OVERLAYS[name][1]}
            .checked=${model.overlays[name]}
            @change=${(event: Event) => {
              event.stopPropagation();
              actions.overlay(name, (event.target as HTMLInputElement).checked);
            }}
            @input=${(event: Event) => event.stopPropagation()}
          />${OVERLAYS[name][0]}
        </label>`,
      )}
    </div>
  </div>`;
}

/** Places a popover, which lies in the top layer, in coordinates of the window. */
function placeBelowButton(event: Event): void {
  const popover = event.currentTarget as HTMLElement;
  const button = popover.previousElementSibling;
  if (!button) return;
  const { left, bottom } = button.getBoundingClientRect();
  popover.style.left = `${Math.min(left, innerWidth - 220)}px`;
  popover.style.top = `${bottom + 6}px`;
}

function themeButton(model: EditorModel, actions: EditorActions): TemplateResult {
  const label = model.dark ? 'Light colours' : 'Dark colours';
  return html`<button
    type="button"
    class="button theme"
    part="button"
    data-tip=${label}
    aria-label=${label}
    @click=${() => actions.theme()}
  >
    ${icon(model.dark ? 'light' : 'dark')}
  </button>`;
}
