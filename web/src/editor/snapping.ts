/** Snapping to guides: the axes of symmetry of the picture, the places of other handles, and a grid. */
import { corners } from '../document/handle';
import { type Guide, type Guides, gridStep, type SnappedPlace, snappedTo } from '../geometry/guides';
import type { Vec } from '../geometry/vec';
import { type EditorState, projectOf } from './state';

/** The distance within which a place snaps, for a mouse and for a finger. CSS pixels. */
const REACH = { fine: 6, coarse: 10 } as const;

/** @param moving ids of the handles that move: they are no guides. */
export function snapped(state: EditorState, at: Vec, moving: readonly string[]): SnappedPlace {
  if (!state.display.snapping || state.page.posable) return { at, guides: [] };
  const reach = REACH[state.pointer.coarse ? 'coarse' : 'fine'] / state.view.camera.scale;
  return snappedTo(at, guidesOf(state, moving), reach);
}

function guidesOf(state: EditorState, moving: readonly string[]): Guides {
  const axes = state.solution.shown?.deformation.symmetry();
  const middle = ([0, 1] as const).flatMap((axis): readonly Guide[] => {
    const at = axes?.[axis === 0 ? 'x' : 'y'] ?? null;
    return at === null ? [] : [{ axis, at }];
  });
  const others = projectOf(state).handles.filter(({ id }) => !moving.includes(id));
  const places = others.flatMap((handle) => corners(handle));
  const through = places.flatMap(([x, y]): readonly Guide[] => [
    { axis: 0, at: x },
    { axis: 1, at: y },
  ]);
  return { lines: [...middle, ...through], grid: gridStep(state.view.camera.scale) };
}
