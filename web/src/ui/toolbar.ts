/** The bar above: documents, history, what is shown, and the name of the picture. */
import { html, type TemplateResult } from 'lit';
import { commandButton, type Look } from './command_button';
import type { CommandName } from './commands';
import { holdButton } from './hold_button';
import { icon } from './icons';
import { keysButton } from './keys';
import type { EditorActions, EditorModel } from './model';
import { overlayMenu } from './overlay_menu';

export function topBar(model: EditorModel, actions: EditorActions): TemplateResult {
  const command = (name: CommandName, look?: Look) => commandButton(name, model, actions, look);
  return html`<div class="top" part="toolbar" role="group" aria-label="Document">
    <span class="brand" aria-hidden="true">c<sup>2</sup>warp</span>
    <div class="group">
      ${command('open', { text: 'Open' })}
      ${command('save', { text: 'Save' })}
      ${command('export', { text: 'Export' })}
    </div>
    <div class="group">
      ${command('undo', { label: told('Undo', model.undo) })}
      ${command('redo', { label: told('Redo', model.redo) })}
    </div>
    <div class="group">
      ${command('reset-all')}
      ${holdButton('compare', model, actions)} ${overlayMenu(model, actions)}
    </div>
    <span class="title" title=${model.picture?.name ?? ''}>${model.picture?.name ?? ''}</span>
    ${keysButton()} ${themeButton(model, actions)}
  </div>`;
}

const told = (verb: string, label: string | null): string =>
  label === null ? verb : `${verb}: ${label.charAt(0).toLowerCase()}${label.slice(1)}`;

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
