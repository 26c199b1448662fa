/** The lasso along edges of the picture. */
import { edgeNear, edgePath, finePath } from '../geometry/scissors';
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
  if (!snapsToEdges(state) || !luminance || luminance.of !== picture) return null;
  const reach = (pointer.coarse ? REACH.coarse : REACH.fine) / view.camera.scale;
  return (from, to, precise = false) => {
    const end = edgeNear(luminance.values, to, reach);
    return from ? (precise ? finePath : edgePath)(luminance.values, from, end) : [end];
  };
}
