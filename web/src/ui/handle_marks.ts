/**
 * The marks of handles beside their dots: rest positions, dotted lines from there, the lines of bars and polygons, and
 * the rotation ring of the selection.
 */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import { anchor, corners, isClosed, isInPlace, isLine, rotationOf } from '../document/handle';
import type { LineHandle } from '../document/project';
import type { EditorModel } from '../editor/view_model';
import { type Size, toStage } from '../geometry/camera';
import { distance, type Vec } from '../geometry/vec';
import { GRIP_DEGREES, groupRing } from '../tools/group_ring';
import { dots, onStage } from './dots';

export function handleMarks(model: EditorModel): SVGTemplateResult {
  const { document, camera, stage, grips, turns, posable, ringed } = model;
  const group = model.readonly ? null : groupRing(document, grips);
  const single = grips.ring * camera.scale;
  const radius = group ? group.radius * camera.scale : single;
  return svg`${document.project.handles.map((handle) => {
    const rest = toStage(camera, anchor(handle, 'rest'));
    const posed = toStage(camera, anchor(handle));
    const selected = document.selection.includes(handle.id);
    return svg`
      ${isLine(handle) ? lineMarks(handle, model, selected) : !posable && distance(rest, posed) > 4 ? restMark(rest, posed, stage) : nothing}
      ${(selected && !model.readonly && !group) || handle.id === ringed ? ring(posed, rotationOf(handle, turns), selected ? radius : single) : nothing}`;
  })}${group ? ring(toStage(camera, group.pivot), group.turn, radius, groupMarks(radius)) : nothing}`;
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

/** A posed bar or polygon, and faintly its rest position once it has moved. */
function lineMarks(
  handle: LineHandle,
  { camera, stage, posable }: EditorModel,
  selected: boolean,
): SVGTemplateResult {
  const closed = isClosed(handle.kind);
  const places = (of: 'rest' | 'posed') => corners(handle, of).map((corner) => toStage(camera, corner));
  const [rest, posed] = [places('rest'), `M${places('posed').join('L')}${closed ? 'Z' : ''}`];
  return svg`
    ${posable || isInPlace(handle) ? nothing : svg`<g class="rest">${restLine(rest, closed, stage)}</g>`}
    <g class="line-handle ${selected ? 'selected' : ''}">
      ${closed ? svg`<path class="body" d=${posed}/>` : nothing}
      <path class="casing" d=${posed}/><path class="line" d=${posed}/>
    </g>`;
}

/** A rotation ring. Its knob is at the top at rotation 0. */
const ring = (
  [x, y]: Vec,
  rotation: number,
  radius: number,
  more: SVGTemplateResult | typeof nothing = nothing,
): SVGTemplateResult => svg`<g
  class="ring" transform="translate(${x} ${y}) rotate(${rotation})">
  <circle class="under" r=${radius}/>
  <circle r=${radius}/>
  <circle class="knob" cy=${-radius} r="5.5"/>
  ${more}
</g>`;

/** The centre of a group, and the grip that scales it. */
const groupMarks = (radius: number): SVGTemplateResult => svg`
  <path class="under" d="M-5 0H5M0 -5V5"/><path d="M-5 0H5M0 -5V5"/>
  <rect class="knob" transform="rotate(${GRIP_DEGREES})" x="-5" y=${-radius - 5} width="10" height="10" rx="1.5"/>`;
