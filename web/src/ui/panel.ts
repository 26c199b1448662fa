/**
 * The property panel: the overlays if they are open, the numbers of the selected handles, how the picture bends, and
 * the list of all handles.
 *
 * On a phone it is a sheet with one of the first three. For selected handles the sheet shows one line, and a press
 * shows the numbers. It keeps clear of the selected handles, and hides during a drag.
 */
import { html, nothing, type TemplateResult } from 'lit-html';
import { classMap } from 'lit-html/directives/class-map.js';
import { selectedHandles } from '../document/document';
import { groupCentre } from '../document/group';
import { anchor, isLine } from '../document/handle';
import type { Handle } from '../document/project';
import type { Dispatch } from '../editor/events';
import { FROM_BOTTOM, SHEET } from '../editor/sizes';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';
import { bending } from './bending';
import { commandButton } from './command_button';
import { cornerFields } from './corner_fields';
import { fields } from './fields';
import { handleList } from './handle_list';
import { icon } from './icons';
import { nameTitle } from './name_field';
import { overlayList } from './overlay_list';

export function panel(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const selected = selectedHandles(model.document);
  const { settings, numbers, pressing, overlayList: overlaid } = model;
  const looks = {
    open: selected.length > 0 || settings || overlaid,
    settings,
    numbers,
    overlaid,
    away: pressing && !settings && !overlaid,
    high: !settings && !overlaid && isLow(selected, model),
  };
  return html`<section class="panel card ${classMap(looks)}" part="panel" aria-label=${model.texts.panel.label}>
    ${overlaid ? overlayList(model, dispatch) : nothing}
    ${selected.length > 0 ? properties(selected, model, dispatch) : nothing}
    ${bending(model, dispatch, selected.length === 0 || settings)} ${handleList(model, dispatch)}
    <slot name="panel"></slot>
  </section>`;
}

/** Room for a handle's dot beside the sheet, CSS pixels. */
const DOT = 14;

/** Whether the sheet would cover the selected handles at the bottom of the stage, and less so at its top. */
function isLow(selected: readonly Handle[], { camera, stage, numbers, corner }: EditorModel): boolean {
  const [first] = selected;
  if (!first) return false;
  const inHand = corner !== null && isLine(first) ? first.posed[corner] : undefined;
  const [, y] = toStage(camera, inHand ?? groupCentre(selected));
  const sheet = numbers ? (inHand ? SHEET.ofCorner : SHEET.numbers) : SHEET.line;
  const [low, high] = [stage.height - FROM_BOTTOM.sheet - sheet - DOT, SHEET.top + sheet + DOT];
  return y > Math.max(low, (low + high) / 2);
}

function properties(selected: readonly Handle[], model: EditorModel, dispatch: Dispatch): TemplateResult {
  const [first] = selected;
  if (!first) return html``;
  const { panel: words, names } = model.texts;
  const [x, y] = anchor(first, 'rest');
  return html`<section class="properties" aria-label=${words.selected}>
    ${selected.length === 1 ? nameTitle(first, model, dispatch) : html`<h2>${names.handles(selected.length)}</h2>`}
    ${fields(selected, model, dispatch)}
    ${selected.length === 1 && isLine(first) ? cornerFields(first, model, dispatch) : nothing}
    <div class="row">
      <span class="faint">${selected.length === 1 ? words.restsAt(Math.round(x), Math.round(y)) : ''}</span>
      <button
        type="button"
        class="button unfold"
        part="button"
        aria-label=${words.numbers}
        aria-expanded=${String(model.numbers)}
        @click=${() => dispatch({ type: 'numbers-opened', open: !model.numbers })}
      >
        ${icon('unfold')}
      </button>
      ${commandButton('mirror', model, dispatch)}
      ${commandButton('reset', model, dispatch, { label: words.resetToRest })}
      ${commandButton('remove', model, dispatch)}
    </div>
  </section>`;
}
