/** The ghost of a handle that the guard against folds holds back: where it was asked to go. */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import { anchor, corners, isClosed, isLine } from '../document/handle';
import type { Handle } from '../document/project';
import type { EditorModel } from '../editor/view_model';
import { type Camera, toStage } from '../geometry/camera';
import { dots, onStage } from './dots';

/** The words beside the ghost, away from the handle: their width, and the distance of their middle, CSS pixels. */
const WORDS = { width: 120, apart: 78 };

/** Stays after the drag, without `held`, to fade away. */
export function askedMarks({
  asked,
  holding,
  document,
  camera,
  stage,
  texts,
}: EditorModel): SVGTemplateResult | typeof nothing {
  const [first] = asked;
  if (!first) return nothing;
  const present = new Map(document.project.handles.map((handle) => [handle.id, handle]));
  const [x, y] = toStage(camera, anchor(first));
  const from = present.get(first.id);
  const side = from && anchor(from)[0] < anchor(first)[0] ? 1 : -1;
  return svg`<g class="asked ${holding ? 'held' : ''}">
    ${asked.map((handle) => {
      const held = present.get(handle.id);
      const way = held ? [anchor(held), anchor(handle)].map((place) => toStage(camera, place)) : [];
      const path = onStage(way, false, stage);
      return svg`${dots('dots under', path)}${dots('dots', path)}${ghost(handle, camera)}`;
    })}
    <g class="words" transform="translate(${x + side * WORDS.apart} ${y})">
      <rect x=${-WORDS.width / 2} y="-13" width=${WORDS.width} height="26" rx="13"/>
      <text dy="4.5">${texts.stage.wouldFold}</text>
    </g>
  </g>`;
}

function ghost(handle: Handle, camera: Camera): SVGTemplateResult {
  const places = corners(handle).map((corner) => toStage(camera, corner));
  if (isLine(handle))
    return svg`<path class="shape" d=${`M${places.join('L')}${isClosed(handle.kind) ? 'Z' : ''}`}/>`;
  const [[x, y] = [0, 0]] = places;
  return svg`<circle class="shape" cx=${x} cy=${y} r="8"/>`;
}
