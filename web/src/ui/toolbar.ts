/** The bar at the top: documents, history, overlays, and the name of the picture. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { CommandName } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { commandButton, type Look } from './command_button';
import { exportMenu } from './export/menu';
import type { ExportPages } from './export_pages';
import { filesMenu } from './files_menu';
import { holdButton } from './hold_button';
import { keysButton } from './keys';
import { moreMenu } from './more_menu';
import { overlayButton } from './overlay_list';
import { themeButton } from './theme';

/** @param pages see `exportMenu`. */
export function topBar(model: EditorModel, dispatch: Dispatch, pages: ExportPages | null): TemplateResult {
  const command = (name: CommandName, look?: Look) => commandButton(name, model, dispatch, look);
  return html`<div class="top" part="toolbar" role="group" aria-label="Document">
    <span class="brand" aria-hidden="true">c<sup>2</sup>warp</span>
    <div class="group">
      ${command('open', { text: 'Open' })} ${model.offers('open') ? filesMenu(model, dispatch) : nothing}
      ${command('save', { text: 'Save' })}
      ${model.offers('export') ? exportMenu(model, dispatch, pages) : nothing}
    </div>
    <div class="group">
      ${command('undo', { label: told('Undo', model.undo), caption: 'Undo' })}
      ${command('redo', { label: told('Redo', model.redo), caption: 'Redo' })}
    </div>
    <div class="group">
      ${command('reset-all')}
      ${holdButton('compare', 'Compare', model, dispatch)} ${overlayButton(model, dispatch)}
    </div>
    <div class="group">${command('timeline', { text: 'Animate', pressed: model.timeline !== null })}</div>
    ${moreMenu(model, dispatch)}
    <slot name="toolbar"></slot>
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
