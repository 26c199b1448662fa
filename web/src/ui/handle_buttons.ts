/**
 * One focusable button per handle and per corner, over the picture, for keyboards and screen readers. Pointer presses
 * go to the stage, where the tools take them.
 *
 * Styles are set as properties, since a Content Security Policy may refuse style attributes.
 */

import { html, nothing, type TemplateResult } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import {
  anchor,
  depthOf,
  type HiddenCorners,
  isLine,
  rotationOf,
  rounded,
  scaleOf,
  type Turns,
} from '../document/handle';
import { nameWords } from '../document/names';
import type { Handle, LineHandle } from '../document/project';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import type { Texts } from '../texts/texts';
import { worded } from '../texts/wording';

/** The label of a handle for screen readers. */
export function handleLabel(handle: Handle, turns: Turns, hidden: HiddenCorners, texts: Texts): string {
  const [x, y] = anchor(handle);
  const scale = rounded(scaleOf(handle));
  const depth = depthOf(handle);
  const { spoken } = texts;
  const name = worded(texts, nameWords(handle));
  return texts.names.parts([
    isLine(handle) ? spoken[handle.kind](name, handle.posed.length) : spoken.point(name),
    spoken.x(Math.round(x)),
    spoken.y(Math.round(y)),
    spoken.rotation(Math.round(rotationOf(handle, turns))),
    ...(scale === 1 ? [] : [spoken.scale(scale)]),
    ...(depth === 0 ? [] : [spoken.depth(depth)]),
    ...(isBehind(handle, hidden) ? [spoken.behind] : []),
  ]);
}

/** Whether all corners lie behind another part of the picture. */
const isBehind = ({ id }: Handle, hidden: HiddenCorners): boolean =>
  hidden.get(id)?.every((corner) => corner) ?? false;

export function handleButtons(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { document, camera } = model;
  return html`<div class="handles ${model.draft ? 'drawing' : ''}" role="group" aria-label=${model.texts.stage.handles}>
    ${repeat(
      document.project.handles,
      (handle) => handle.id,
      (handle) => {
        const [x, y] = toStage(camera, anchor(handle));
        const selected = document.selection.includes(handle.id);
        return html`<button
            type="button"
            class="handle ${isLine(handle) ? 'middle-mark' : ''} ${isBehind(handle, model.hidden) ? 'behind' : ''}"
            part="handle"
            data-handle=${handle.id}
            aria-label=${handleLabel(handle, model.turns, model.hidden, model.texts)}
            aria-pressed=${selected ? 'true' : 'false'}
            .style=${`transform: translate(${x}px, ${y}px)`}
            @focus=${(event: FocusEvent) => focused(event, handle.id, anchor(handle), model, dispatch)}
            @keydown=${(event: KeyboardEvent) => entered(event, handle.id, model, dispatch)}
            @click=${(event: MouseEvent) => event.detail === 0 && dispatch({ type: 'handle-toggled', id: handle.id })}
          ></button>
          ${isLine(handle) ? cornerButtons(handle, selected, model, dispatch) : nothing}`;
      },
    )}
  </div>`;
}

/** Only the corners of selected handles are tab stops, since all corners would be too many. */
const cornerButtons = (
  handle: LineHandle,
  selected: boolean,
  model: EditorModel,
  dispatch: Dispatch,
): readonly TemplateResult[] =>
  handle.posed.map((corner, index) => {
    const [x, y] = toStage(model.camera, corner);
    const [left = 0, top = 0] = corner.map(Math.round);
    const inHand = selected && model.corner === index;
    const behind = model.hidden.get(handle.id)?.[index];
    return html`<button
      type="button"
      class="handle corner ${selected ? 'selected' : ''} ${inHand ? 'in-hand' : ''} ${behind ? 'behind' : ''}"
      part="handle"
      data-of=${handle.id}
      data-corner=${index}
      tabindex=${selected ? 0 : -1}
      aria-label=${model.texts.spoken.corner(index + 1, model.worded(nameWords(handle)), left, top)}
      .style=${`transform: translate(${x}px, ${y}px)`}
      @focus=${(event: FocusEvent) => focused(event, handle.id, corner, model, dispatch)}
      @keydown=${(event: KeyboardEvent) => entered(event, handle.id, model, dispatch)}
      @click=${(event: MouseEvent) => event.detail === 0 && dispatch({ type: 'handle-toggled', id: handle.id })}
    ></button>`;
  });

/**
 * Enter takes a handle and never lets go of it; at the crosshair or during a drawing it is left to the tool. Screen
 * readers toggle by a click without a pointer.
 */
function entered(event: KeyboardEvent, id: string, model: EditorModel, dispatch: Dispatch): void {
  if (event.key !== 'Enter' || model.crosshair || model.draft) return;
  event.preventDefault();
  if (!model.document.selection.includes(id)) dispatch({ type: 'handles-selected', ids: [id] });
}

/** Whether the focus came by a key. */
export const isKeyed = (target: Element): boolean =>
  (target.getRootNode() as ShadowRoot).host.classList.contains('keyed');

/** Keyboard focus selects a handle and brings it into view; a pointer selects through the tools. */
function focused(event: FocusEvent, id: string, at: Vec, model: EditorModel, dispatch: Dispatch): void {
  const keyboard = event.target instanceof Element && event.target.matches(':focus-visible');
  // A press focuses a handle too. That handle is in view already, and must stay under the finger.
  if (keyboard && isKeyed(event.target)) dispatch({ type: 'place-revealed', at });
  if (keyboard && !model.draft && !model.document.selection.includes(id))
    dispatch({ type: 'handles-selected', ids: [id] });
}
