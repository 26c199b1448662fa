/** The bar at the top: documents, history, overlays, and the name of the picture. */
import { html, nothing, type TemplateResult } from 'lit';
import type { CommandName } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { commandButton, type Look } from './command_button';
import { exportMenu } from './export_menu';
import { filesMenu } from './files_menu';
import { holdButton } from './hold_button';
import { icon } from './icons';
import { keysButton } from './keys';
import { overlayMenu } from './overlay_menu';

export function topBar(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const command = (name: CommandName, look?: Look) => commandButton(name, model, dispatch, look);
  return html`<div class="top" part="toolbar" role="group" aria-label="Document">
    <span class="brand" aria-hidden="true">c<sup>2</sup>warp</span>
    <div class="group">
      ${command('open', { text: 'Open' })} ${filesMenu(model, dispatch)}
      ${command('save', { text: 'Save' })}
      ${exportMenu(model, dispatch)}
    </div>
    <div class="group">
      ${command('undo', { label: told('Undo', model.undo) })}
      ${command('redo', { label: told('Redo', model.redo) })}
    </div>
    <div class="group">
      ${command('reset-all')}
      ${holdButton('compare', model, dispatch)} ${overlayMenu(model, dispatch)}
    </div>
    ${title(model)}
    ${keysButton()} ${themeButton(model, dispatch)}
  </div>`;
}

const told = (verb: string, label: string | null): string =>
  label === null ? verb : `${verb}: ${label.charAt(0).toLowerCase()}${label.slice(1)}`;

function title({ picture, unsaved, kept }: EditorModel): TemplateResult {
  const name = picture?.name ?? '';
  const state = unsaved ? (kept ? 'Unsaved, kept in this browser' : 'Unsaved') : '';
  const tip = [name, unsaved ? 'no file holds the last changes' : '', kept ? 'kept in this browser' : '']
    .filter(Boolean)
    .join(', ');
  return html`<span class="title ${unsaved ? 'unsaved' : ''}" title=${tip}>
    <span class="name">${name}</span>${state ? html`<span class="kept">${state}</span>` : nothing}
  </span>`;
}

function themeButton(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const label = model.dark ? 'Light colours' : 'Dark colours';
  return html`<button
    type="button"
    class="button theme"
    part="button"
    data-tip=${label}
    aria-label=${label}
    @click=${() => dispatch({ type: 'theme-switched' })}
  >
    ${icon(model.dark ? 'light' : 'dark')}
  </button>`;
}
