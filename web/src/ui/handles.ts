/**
 * The handles over the picture: a faint mark where each rests, a thread to where it is posed, the rotation ring of the
 * selected ones, and over them one focusable button per handle, and per corner of a bar or polygon. The buttons are for
 * keyboards and screen readers too; presses of a pointer go to the stage, which knows the tools.
 *
 * Styles are set as properties: a Content Security Policy may refuse what stands in an attribute.
 */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import {
  anchor,
  corners,
  depthOf,
  isInPlace,
  isLine,
  nameOf,
  rotationOf,
  scaleOf,
  type Turns,
} from '../document/handle';
import type { Handle, LineHandle } from '../document/project';
import { type Size, toStage } from '../geometry/camera';
import { distance, type Vec } from '../geometry/vec';
import { dots, onStage } from './dots';
import type { EditorActions, EditorModel } from './model';

/** What a screen reader says of a handle. */
export function handleLabel(handle: Handle, turns: Turns): string {
  const [x, y] = anchor(handle);
  const scale = scaleOf(handle);
  const depth = depthOf(handle);
  return [
    `Handle ${nameOf(handle)}`,
    ...(isLine(handle) ? [`${handle.kind} with ${handle.posed.length} corners`] : []),
    `x ${Math.round(x)}`,
    `y ${Math.round(y)}`,
    `rotation ${Math.round(rotationOf(handle, turns))} degrees`,
    ...(scale === 1 ? [] : [`scale ${scale}`]),
    ...(depth === 0 ? [] : [`depth ${depth}`]),
  ].join(', ');
}

export function handleMarks(model: EditorModel): SVGTemplateResult {
  const { document, camera, stage, grips, turns, playing } = model;
  const radius = grips.ring * camera.scale;
  return svg`${document.project.handles.map((handle) => {
    const rest = toStage(camera, anchor(handle, 'rest'));
    const posed = toStage(camera, anchor(handle));
    const selected = document.selection.includes(handle.id);
    return svg`
      ${isLine(handle) ? lineMarks(handle, model, selected) : !playing && distance(rest, posed) > 4 ? restMark(rest, posed, stage) : nothing}
      ${selected && !model.readonly ? ring(posed, rotationOf(handle, turns), radius) : nothing}`;
  })}`;
}

const restMark = (rest: Vec, posed: Vec, stage: Size): SVGTemplateResult => svg`<g class="rest">
  ${restLine([rest, posed], false, stage)}
  <circle class="under" cx=${rest[0]} cy=${rest[1]} r="4.5"/>
  <circle cx=${rest[0]} cy=${rest[1]} r="4.5"/>
</g>`;

/** Twice, the first time dark and wider: it reads on any picture. */
function restLine(places: readonly Vec[], closed: boolean, stage: Size): SVGTemplateResult {
  const path = onStage(places, closed, stage);
  return svg`${dots('dots under', path)}${dots('dots', path)}`;
}

/** Where a bar or polygon rests, faintly, as soon as it is elsewhere; and where it is. */
function lineMarks(
  handle: LineHandle,
  { camera, stage, playing }: EditorModel,
  selected: boolean,
): SVGTemplateResult {
  const closed = handle.kind === 'polygon';
  const places = (of: 'rest' | 'posed') => corners(handle, of).map((corner) => toStage(camera, corner));
  const [rest, posed] = [places('rest'), `M${places('posed').join('L')}${closed ? 'Z' : ''}`];
  return svg`
    ${playing || isInPlace(handle) ? nothing : svg`<g class="rest">${restLine(rest, closed, stage)}</g>`}
    <g class="line-handle ${selected ? 'selected' : ''}">
      ${closed ? svg`<path class="body" d=${posed}/>` : nothing}
      <path class="casing" d=${posed}/><path class="line" d=${posed}/>
    </g>`;
}

/** The knob stands at the top when nothing is turned. */
const ring = ([x, y]: Vec, rotation: number, radius: number): SVGTemplateResult => svg`<g
  class="ring" transform="translate(${x} ${y}) rotate(${rotation})">
  <circle class="under" r=${radius}/>
  <circle r=${radius}/>
  <circle class="knob" cy=${-radius} r="5.5"/>
</g>`;

export function handleButtons(model: EditorModel, actions: EditorActions): TemplateResult {
  const { document, camera } = model;
  return html`<div class="handles ${model.draft ? 'drawing' : ''}" role="application" aria-label="Handles">
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
            @focus=${(event: FocusEvent) => focused(event, handle.id, anchor(handle), model, actions)}
            @click=${(event: MouseEvent) => event.detail === 0 && actions.toggle(handle.id)}
          ></button>
          ${isLine(handle) ? cornerButtons(handle, selected, model, actions) : nothing}`;
      },
    )}
  </div>`;
}

/** The Tab key comes by the corners of what is selected only: of many handles it would never get through. */
const cornerButtons = (
  handle: LineHandle,
  selected: boolean,
  model: EditorModel,
  actions: EditorActions,
): readonly TemplateResult[] =>
  handle.posed.map((corner, index) => {
    const [x, y] = toStage(model.camera, corner);
    const [left, top] = corner.map(Math.round);
    return html`<button
      type="button"
      class="handle corner ${selected ? 'selected' : ''}"
      part="handle"
      data-of=${handle.id}
      data-corner=${index}
      tabindex=${selected ? 0 : -1}
      aria-label="Corner ${index + 1} of ${nameOf(handle)}, x ${left}, y ${top}"
      .style=${`transform: translate(${x}px, ${y}px)`}
      @focus=${(event: FocusEvent) => focused(event, handle.id, corner, model, actions)}
      @click=${(event: MouseEvent) => event.detail === 0 && actions.toggle(handle.id)}
    ></button>`;
  });

const isKeyed = (target: Element): boolean =>
  (target.getRootNode() as ShadowRoot).host.classList.contains('keyed');

/** The keyboard selects as it goes from handle to handle, and takes the view along; a pointer has its own way to select. */
function focused(event: FocusEvent, id: string, at: Vec, model: EditorModel, actions: EditorActions): void {
  const keyboard = event.target instanceof Element && event.target.matches(':focus-visible');
  // After a press too the focus goes to a handle: that one is in view, and stays under the finger.
  if (keyboard && isKeyed(event.target)) actions.reveal(at);
  if (keyboard && !model.draft && !model.document.selection.includes(id)) actions.select([id]);
}

/** The box of a drag over empty space, in stage pixels. */
export function selectionBox({ box, camera }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!box) return nothing;
  const [x, y] = toStage(camera, box.min);
  const [right, bottom] = toStage(camera, box.max);
  return svg`<rect class="box" x=${x} y=${y} width=${right - x} height=${bottom - y}/>`;
}

/** Where the keyboard would place a handle. */
export function crosshair({ crosshair: at, camera }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!at) return nothing;
  const [x, y] = toStage(camera, at);
  return svg`<g class="crosshair" transform="translate(${x} ${y})">
    <path class="under" d="M-14 0H14M0 -14V14"/><path d="M-14 0H14M0 -14V14"/>
  </g>`;
}
