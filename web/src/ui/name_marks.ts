/**
 * Names on the stage: the number of each handle that nobody has named, and the names of the handle under the pointer
 * and the selected one. They keep clear of other handles where that is possible.
 */
import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import { anchor, corners, isLine } from '../document/handle';
import { nameWords, numberOf } from '../document/names';
import type { Handle } from '../document/project';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';
import { clearPlace } from '../geometry/clear_place';
import type { Vec } from '../geometry/vec';

/** Sizes of a line of text, CSS pixels. The width of a character is that of wide fonts. */
const TEXT = { character: 7.4, height: 14 } as const;

/** Characters of a name. A longer one would lie over most of the picture. */
const MOST = 40;

/** The radius of a dot with its shadow, CSS pixels. */
const DOT = 11;

export function nameMarks(model: EditorModel): SVGTemplateResult {
  const { document, camera, named, posable } = model;
  if (posable) return svg``;
  const dots = document.project.handles.flatMap((handle) =>
    corners(handle).map((corner) => ({ handle, at: toStage(camera, corner) })),
  );
  const others = (handle: Handle) =>
    dots.filter((dot) => dot.handle !== handle || isLine(handle)).map(({ at }) => at);
  return svg`${document.project.handles.map((handle) => {
    const isNamed = named.includes(handle.id);
    const text = isNamed ? short(capital(model.worded(nameWords(handle)))) : numberOf(handle);
    if (text === null) return nothing;
    const size = { width: TEXT.character * text.length, height: TEXT.height };
    const at = toStage(camera, anchor(handle));
    const places = isNamed ? aroundRing(at, size.width, radiusOf(handle, model)) : atCorners(at, size.width);
    const [x, y] = clearPlace(places, size, others(handle), DOT, model.stage);
    return svg`<text class="name ${isNamed ? '' : 'number'}" x=${x} y=${y}>${text}</text>`;
  })}`;
}

function short(name: string): string {
  const signs = [...name];
  return signs.length > MOST ? `${signs.slice(0, MOST - 1).join('')}…` : name;
}

const capital = (name: string): string => name.charAt(0).toUpperCase() + name.slice(1);

/** The radius of the ring of a handle, or of its dot. */
const radiusOf = ({ id }: Handle, { document, readonly, ringed, grips, camera }: EditorModel): number =>
  (document.selection.includes(id) && !readonly) || ringed === id ? grips.ring * camera.scale + 4 : DOT;

type Places = readonly [Vec, ...Vec[]];

/** Below, above, and beside. */
function aroundRing([x, y]: Vec, width: number, radius: number): Places {
  const [down, across] = [radius + 12, radius + 6 + width / 2];
  return [
    [x, y + down],
    [x, y - down - 4],
    [x + across, y],
    [x - across, y],
  ];
}

/** Above at the right, and then clockwise. */
function atCorners([x, y]: Vec, width: number): Places {
  const [across, down] = [DOT + width / 2, DOT];
  return [
    [x + across, y - down],
    [x + across, y + down],
    [x - across, y + down],
    [x - across, y - down],
  ];
}
