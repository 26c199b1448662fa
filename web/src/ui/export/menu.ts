/** The export panel, with a page for each kind of export. On a phone it is a sheet. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { ariaKeys, keyHint } from '../../editor/commands';
import type { Dispatch } from '../../editor/events';
import type { ExportKind } from '../../editor/export_choices';
import type { EditorModel } from '../../editor/view_model';
import { placeBelowButton } from '../below_button';
import { captionOf } from '../command_button';
import type { ExportPages } from '../export_pages';
import { icon } from '../icons';
import { choice } from './controls';
import { picturePage } from './picture';

/** @param pages those that are loaded later; null until then. */
export function exportMenu(
  model: EditorModel,
  dispatch: Dispatch,
  pages: ExportPages | null,
): TemplateResult {
  const { texts } = model;
  const label = texts.commands['export-as'];
  const word = texts.toolbar.export;
  const { kind, kinds } = texts.exporting;
  const shown = page(model, dispatch, pages);
  return html`<div class="menu">
    <button
      type="button"
      class="button worded"
      part="button"
      popovertarget="export"
      data-tip=${label}
      data-keys=${keyHint('export-as', model.platform, texts)}
      aria-label=${label}
      aria-keyshortcuts=${ariaKeys('export-as', model.platform) || nothing}
      ?disabled=${!model.canRun('export')}
    >
      ${icon('export')}<span class="word">${word}</span>${captionOf(word)}
    </button>
    <div
      id="export"
      class="popover card export"
      part="menu"
      popover
      role="dialog"
      aria-label=${word}
      aria-busy=${String(shown === nothing)}
      tabindex="-1"
      @beforetoggle=${(event: ToggleEvent) => {
        placeBelowButton(event);
        dispatch({ type: 'popover-toggled', popover: 'export', open: event.newState === 'open' });
      }}
    >
      ${choice<ExportKind>(kind, kinds, model.exporting.kind, (kind) => dispatch({ type: 'export-kind-chosen', kind }))}
      ${shown}
    </div>
  </div>`;
}

/** Opens or closes the panel. */
export const toggleExport = (root: ShadowRoot): unknown =>
  root.querySelector<HTMLElement>('#export')?.togglePopover();

/** Focuses the button of the open panel, so that Enter exports. Another control there keeps the focus. */
export function focusExport(root: ShadowRoot): void {
  const panel = root.querySelector('#export:popover-open');
  if (!panel?.contains(root.activeElement)) panel?.querySelector<HTMLElement>('.primary')?.focus();
}

function page(
  model: EditorModel,
  dispatch: Dispatch,
  pages: ExportPages | null,
): TemplateResult | typeof nothing {
  const { kind, film, page, engine, maps } = model.exporting;
  if (kind === 'picture') return picturePage(model, dispatch);
  if (engine) return pages?.engine(engine, model, dispatch) ?? nothing;
  if (maps) return pages?.maps(maps, model, dispatch) ?? nothing;
  if (film) return pages?.film(film, model, dispatch) ?? nothing;
  return (page && pages?.page(page, model, dispatch)) ?? nothing;
}
