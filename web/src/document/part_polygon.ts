/** Parts of a picture that turn while the rest bends along: polygons around them take the place of a lasso. */
import { simpleRing } from '../geometry/enclosed';
import { simplified } from '../geometry/polyline_simplified';
import { areaOf, clipped, islandsOf, type Ring } from '../geometry/ring';
import type { Vec } from '../geometry/vec';
import type { Document } from './document';
import { LEAST_AREA, ringsOf, withoutLasso } from './domain';
import { addHandle, freeId } from './edits';
import { CORNERS_NEEDED, roundedVec } from './handle';
import type { Handle, Project } from './project';

/** More corners take longer to solve, and are no easier to see. */
const MOST_CORNERS = 16;

/** The least tolerance of an outline and its distance from the frame, as fractions of the picture's longer side. */
const TOLERANCE = 0.004;
const FROM_FRAME = 0.02;

/**
 * Replaces the lasso by selected polygons, one along the outline of each part. All of the picture bends, and its frame
 * is held. Handles stay. Returns null without a lasso, or if a part lies along the frame.
 */
export function withPartPolygons(document: Document): Document | null {
  const { project } = document;
  const outlines = islandsOf(ringsOf(project)).map((ring) => cornersOf(ring, project));
  if (outlines.length === 0) return null;
  let made: Document = { ...document, project: withoutLasso(project, null), selection: [] };
  for (const outline of outlines) {
    if (!outline) return null;
    const id = freeId(made.project, 'polygon');
    const polygon: Handle = { id, kind: 'polygon', rest: outline, posed: outline };
    made = { ...addHandle(made, polygon), selection: [...made.selection, id] };
  }
  return made;
}

/** Few corners within the picture. What lies on the held frame could not turn: null if all of the ring does. */
function cornersOf(ring: Ring, { image: { width, height } }: Project): readonly Vec[] | null {
  const size = Math.max(width, height);
  const room = Math.min(FROM_FRAME * size, width / 4, height / 4);
  const within = clipped(ring, { min: [room, room], max: [width - room, height - room] });
  const [first] = within;
  if (!first || areaOf(within) < LEAST_AREA) return null;
  let corners = within;
  for (let tolerance = TOLERANCE * size; tolerance < size; tolerance *= 1.5) {
    const fewer = simpleRing(simplified([...within, first], tolerance).slice(0, -1));
    if (fewer.length < CORNERS_NEEDED.polygon) break;
    corners = fewer;
    if (corners.length <= MOST_CORNERS) break;
  }
  return corners.map(roundedVec);
}
