/** A part of a picture that turns while the rest bends along: a polygon around it takes the place of a lasso. */
import { simplified } from '../geometry/polyline_simplified';
import { areaOf, type Ring, simpleRing } from '../geometry/ring';
import type { Vec } from '../geometry/vec';
import type { Document } from './document';
import { ringsOf, withFill } from './domain';
import { freeId, selectHandles } from './edits';
import { CORNERS_NEEDED, roundedVec } from './handle';
import type { Handle, Project } from './project';

/** More corners take longer to solve, and are no easier to see. */
const MOST_CORNERS = 16;

/** The least tolerance of an outline and its distance from the frame, as fractions of the picture's longer side. */
const TOLERANCE = 0.004;
const FROM_FRAME = 0.02;

/**
 * Replaces the lasso by a selected polygon along its largest ring. All of the picture bends, and its frame is held.
 * Handles stay. Returns null without a lasso.
 */
export function withPartPolygon(document: Document): Document | null {
  const { project } = document;
  const [largest] = [...ringsOf(project)].sort((a, b) => areaOf(b) - areaOf(a));
  if (!largest) return null;
  const outline = cornersOf(largest, project);
  const id = freeId(project, 'polygon');
  const polygon: Handle = { id, kind: 'polygon', rest: outline, posed: outline };
  const whole: Project = {
    ...withFill(project, false),
    domain: { kind: 'image' },
    fix_boundary: true,
    handles: [...project.handles, polygon],
  };
  return selectHandles({ ...document, project: whole }, [id]);
}

/** Few corners within the picture. What lies on the held frame could not turn. */
function cornersOf(ring: Ring, { image: { width, height } }: Project): readonly Vec[] {
  const size = Math.max(width, height);
  const room = Math.min(FROM_FRAME * size, width / 4, height / 4);
  const within = ring.map(
    ([x, y]): Vec => [Math.min(Math.max(x, room), width - room), Math.min(Math.max(y, room), height - room)],
  );
  const closed = within[0] ? [...within, within[0]] : within;
  let corners: readonly Vec[] = within;
  for (let tolerance = TOLERANCE * size; tolerance < size; tolerance *= 1.5) {
    const fewer = simpleRing(simplified(closed, tolerance).slice(0, -1));
    if (fewer.length < CORNERS_NEEDED.polygon) break;
    corners = fewer;
    if (corners.length <= MOST_CORNERS) break;
  }
  return corners.map(roundedVec);
}
