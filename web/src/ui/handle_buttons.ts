/**
 * One focusable button per handle, and per corner of a bar or polygon, over the picture. The buttons serve keyboards and
 * screen readers too; pointer presses go to the stage, which knows the tools.
 *
 * Styles are set as properties, since a Content Security Policy may refuse style attributes.
 */
import { html, nothing, type TemplateResult } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import {
  anchor,
  depthOf,
  isLine,
  nameOf,
  rotationOf,
  rounded,
  scaleOf,
  type Turns,
  turnWords,
} from '../document/handle';
import type { Handle, LineHandle } from '../document/project';
import { toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import type { EditorActions, EditorModel } from './model';

/** The label of a handle for screen readers. */
export function handleLabel(handle: Handle, turns: Turns): string {
  const [x, y] = anchor(handle);
  const scale = rounded(scaleOf(handle));
  const depth = depthOf(handle);
  return [
    `Handle ${nameOf(handle)}`,
    ...(isLine(handle) ? [`${handle.kind} with ${handle.posed.length} corners`] : []),
    `x ${Math.round(x)}`,
    `y ${Math.round(y)}`,
    turnWords(rotationOf(handle, turns)),
    ...(scale === 1 ? [] : [`scale ${scale}`]),
    ...(depth === 0 ? [] : [`depth ${depth}`]),
  ].join(', ');
}

export function handleButtons(model: EditorModel, actions: EditorActions): TemplateResult {
  const { document, camera } = model;
  return html`<div class="handles ${model.draft ? 'drawing' : ''}" role="group" aria-label="Handles">
    ${repeat(
      document.project.handles,
      (handle) => handle.id,
      (handle) => {
        const [x, y] = toStage(camera, anchor(handle));
        const selected = document.selection.includes(handle.id);
        return html`<button
            type="button"
            class="handle ${isLine(handle) ? 'middle-mark' : ''}"
            part="handle"
            data-handle=${handle.id}
            aria-label=${handleLabel(handle, model.turns)}
            aria-pressed=${selected ? 'true' : 'false'}
            .style=${`transform: translate(${x}px, ${y}px)`}
            @focus=${(event: FocusEvent) => focused(event, handle.id, null, anchor(handle), model, actions)}
            @click=${(event: MouseEvent) => event.detail === 0 && actions.toggle(handle.id)}
          ></button>
          ${isLine(handle) ? cornerButtons(handle, selected, model, actions) : nothing}`;
      },
    )}
  </div>`;
}

/** Only the corners of selected handles are tab stops: all of them would be too many. */
const cornerButtons = (
  handle: LineHandle,
  selected: boolean,
  model: EditorModel,
  actions: EditorActions,
): readonly TemplateResult[] =>
  handle.posed.map((corner, index) => {
    const [x, y] = toStage(model.camera, corner);
    const [left, top] = corner.map(Math.round);
    const inHand = selected && model.corner === index;
    return html`<button
      type="button"
      class="handle corner ${selected ? 'selected' : ''} ${inHand ? 'in-hand' : ''}"
      part="handle"
      data-of=${handle.id}
      data-corner=${index}
      tabindex=${selected ? 0 : -1}
      aria-label="Corner ${index + 1} of ${nameOf(handle)}, x ${left}, y ${top}"
      .style=${`transform: translate(${x}px, ${y}px)`}
      @focus=${(event: FocusEvent) => focused(event, handle.id, index, corner, model, actions)}
      @click=${(event: MouseEvent) => event.detail === 0 && actions.toggle(handle.id)}
    ></button>`;
  });

const isKeyed = (target: Element): boolean =>
  (target.getRootNode() as ShadowRoot).host.classList.contains('keyed');

/** Keyboard focus selects a handle and brings it into view; a pointer selects through the tools. */
function focused(
  event: FocusEvent,
  id: string,
  corner: number | null,
  at: Vec,
  model: EditorModel,
  actions: EditorActions,
): void {
  actions.focused(corner === null ? null : { id, index: corner });
  const keyboard = event.target instanceof Element && event.target.matches(':focus-visible');
  // A press focuses a handle too, but that one is in view already, and must stay under the finger.
  if (keyboard && isKeyed(event.target)) actions.reveal(at);
  if (keyboard && !model.draft && !model.document.selection.includes(id)) actions.select([id]);
}
