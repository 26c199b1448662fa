/** The bar at the top: documents, history, overlays, and the name of the picture. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { CommandName } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { shownName } from '../texts/shown_name';
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
  const { toolbar: words } = model.texts;
  const command = (name: CommandName, look?: Look) => commandButton(name, model, dispatch, look);
  return html`<div class="top" part="toolbar" role="group" aria-label=${words.label}>
    <span class="brand" aria-hidden="true">c<sup>2</sup>warp</span>
    <div class="group">
      ${command('open', { text: words.open })} ${model.offers('open') ? filesMenu(model, dispatch) : nothing}
      ${command('save', { text: words.save })}
      ${model.offers('export') ? exportMenu(model, dispatch, pages) : nothing}
    </div>
    <div class="group">
      ${command('undo', {
        label: model.undo === null ? words.undo : words.undoStep(model.undo),
        caption: words.undo,
      })}
      ${command('redo', {
        label: model.redo === null ? words.redo : words.redoStep(model.redo),
        caption: words.redo,
      })}
    </div>
    <div class="group">
      ${command('reset-all')}
      ${holdButton('compare', words.compare, model, dispatch)} ${overlayButton(model, dispatch)}
    </div>
    <div class="group">${command('timeline', { text: words.animate, pressed: model.timeline !== null })}</div>
    ${moreMenu(model, dispatch)}
    <slot name="toolbar"></slot>
    ${title(model)}
    ${keysButton(model)} ${themeButton(model, dispatch)}
  </div>`;
}

function title({ picture, unsaved, kept, texts }: EditorModel): TemplateResult {
  const name = shownName(picture?.name ?? '');
  const { toolbar: words, names } = texts;
  const state = unsaved ? (kept ? words.unsavedKept : words.unsaved) : '';
  const tip = names.parts([name, unsaved ? words.noFile : '', kept ? words.kept : ''].filter(Boolean));
  return html`<span class="title ${unsaved ? 'unsaved' : ''}" title=${tip}>
    <span class="name">${name}</span>${state ? html`<span class="kept">${state}</span>` : nothing}
  </span>`;
}
