/** The lasso along edges of the picture. */
import { edgeNear, edgePath, finePath } from '../geometry/scissors';
import type { Vec } from '../geometry/vec';
import type { ToolContext } from '../tools/state';
import { isOpaque } from './picture';
import type { EditorState } from './state';

/** How far the end of a way moves to an edge, CSS pixels. */
const REACH = { fine: 9, coarse: 16 } as const;

/** Whether the lasso snaps to edges: as chosen, or in opaque pictures, where no alpha bounds the parts. */
export const snapsToEdges = ({ display, picture }: EditorState): boolean =>
  display.edgeSnapping ?? isOpaque(picture);

/** Null while the lasso does not snap, or the luminance of the picture is not there yet. */
export function traceOf(state: EditorState): ToolContext['trace'] {
  const { luminance, picture, pointer, view } = state;
  if (!snapsToEdges(state) || !picture || !luminance || luminance.of !== picture) return null;
  const { values } = luminance;
  // Paths go through the middle of pixels, half a pixel beside the frame.
  const onFrame = ([x, y]: Vec): Vec => [
    onEnd(x, picture.width, values.step),
    onEnd(y, picture.height, values.step),
  ];
  const reach = (pointer.coarse ? REACH.coarse : REACH.fine) / view.camera.scale;
  return (outline, to, precise = false) => {
    const closes = to === outline[0];
    const end = closes ? to : edgeNear(values, to, reach, outline);
    const way = outline.length > 0 ? (precise ? finePath : edgePath)(values, outline, end) : [end];
    return way.map(onFrame);
  };
}

/** A coordinate, at 0 or the side of a picture if it lies within a distance of these. */
const onEnd = (value: number, side: number, within: number): number =>
  Math.abs(value) <= within ? 0 : Math.abs(value - side) <= within ? side : value;
