/**
 * The handles over the picture: a faint mark where each rests, a dotted line to where it is posed, the rotation ring of
 * selected handles, and on top one focusable button per handle, and per corner of a bar or polygon. The buttons also
 * serve keyboards and screen readers; pointer presses go to the stage, which knows the tools.
 *
 * Styles are set as properties, since a Content Security Policy may refuse style attributes.
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

/** The label of a handle for screen readers. */
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

/** Drawn twice, first dark and wider, to be visible on any picture. */
function restLine(places: readonly Vec[], closed: boolean, stage: Size): SVGTemplateResult {
  const path = onStage(places, closed, stage);
  return svg`${dots('dots under', path)}${dots('dots', path)}`;
}

/** A bar or polygon as posed, and faintly its rest place once it has left that. */
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

/** Keyboard focus selects a handle and brings it into view; a pointer selects through the tools. */
function focused(event: FocusEvent, id: string, at: Vec, model: EditorModel, actions: EditorActions): void {
  const keyboard = event.target instanceof Element && event.target.matches(':focus-visible');
  // A press focuses a handle too, but that one is in view already, and must stay under the finger.
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
