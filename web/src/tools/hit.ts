/** Hit testing: finds the handle, corner, ring or grip under a press. */

import { anchor, isClosed, isLine } from '../document/handle';
import type { Handle } from '../document/project';
import { distanceToLine, isInside } from '../geometry/polyline';
import { distance, type Vec } from '../geometry/vec';
import { type GroupRing, groupRing } from './group_ring';
import type { ToolContext } from './state';

export type Hit =
  | { readonly part: 'handle' | 'ring' | 'grip'; readonly id: string }
  | { readonly part: 'corner'; readonly id: string; readonly index: number };

/** Radius of the hit areas of knob and grip, in multiples of `Grips.band`: 45 px across for a finger. */
const KNOB = 1.25;

/** A candidate, and its distance from the press, image pixels. */
interface Reach {
  readonly hit: Hit;
  readonly away: number;
}

/**
 * Returns the first hit in this order: points, corners and the knob and grip of a group ring; rings; lines; with Alt
 * the ring of {@link ringedHandle}; insides of polygons. In a group of this order, the nearest wins. So a handle inside
 * another handle's ring stays reachable.
 *
 * @param bodies whether the inside of a polygon counts. Tools that place handles ignore it.
 */
export function hit(
  { document, grips }: Pick<ToolContext, 'document' | 'grips'>,
  at: Vec,
  bodies = true,
  alt = false,
): Hit | null {
  const { handles } = document.project;
  const selected = handles.filter(({ id }) => document.selection.includes(id));
  const group = groupRing(document, grips);
  const [first = ''] = document.selection;
  const ringed = alt ? ringedHandle({ document, grips }, at) : null;
  const rings = group
    ? [ring(first, group.pivot, group.radius, at)]
    : selected.map((handle) => ring(handle.id, anchor(handle), grips.ring, at));
  const marks = [
    ...within(
      grips.handle,
      handles.flatMap((handle) => knobs(handle, at)),
    ),
    ...(group ? within(KNOB * grips.band, groupMarks(group, first, at)) : []),
  ];
  return (
    nearest(marks) ??
    nearest(within(grips.band, rings)) ??
    nearest(
      within(
        grips.line,
        handles.map((handle) => line(handle, at, selected.includes(handle))),
      ),
    ) ??
    nearest(within(grips.band, ringed ? [ring(ringed.id, anchor(ringed), grips.ring, at)] : [])) ??
    nearest(bodies ? handles.flatMap((handle) => body(handle, at)) : [])
  );
}

/** The handle that Alt turns beside its ring: the nearest one in reach, unless it is selected. */
export function ringedHandle(
  { document, grips }: Pick<ToolContext, 'document' | 'grips'>,
  at: Vec,
): Handle | null {
  const away = (handle: Handle) => distance(anchor(handle), at);
  let found: Handle | null = null;
  for (const handle of document.project.handles)
    if (away(handle) <= (found ? away(found) : grips.ring + grips.band)) found = handle;
  return found && document.selection.includes(found.id) ? null : found;
}

const within = (most: number, reaches: readonly Reach[]): readonly Reach[] =>
  reaches.filter(({ away }) => away <= most);

/** Of two at the same distance, the later one wins, since it is drawn on top. */
function nearest(reaches: readonly Reach[]): Hit | null {
  let [best, least]: [Hit | null, number] = [null, Number.POSITIVE_INFINITY];
  for (const { hit, away } of reaches) if (away <= least) [best, least] = [hit, away];
  return best;
}

function knobs(handle: Handle, at: Vec): readonly Reach[] {
  const { id } = handle;
  if (!isLine(handle)) return [{ hit: { part: 'handle', id }, away: distance(handle.posed, at) }];
  return handle.posed.map((corner, index) => ({
    hit: { part: 'corner', id, index },
    away: distance(corner, at),
  }));
}

const ring = (id: string, middle: Vec, radius: number, at: Vec): Reach => ({
  hit: { part: 'ring', id },
  away: Math.abs(distance(middle, at) - radius),
});

/** The knob and the grip of a group ring. Their hits have the id of the first handle. */
const groupMarks = ({ knob, grip }: GroupRing, id: string, at: Vec): readonly Reach[] => [
  { hit: { part: 'ring', id }, away: distance(knob, at) },
  { hit: { part: 'grip', id }, away: distance(grip, at) },
];

/** The line. While selected, also the mark at its middle, which can lie off the line. */
const line = (handle: Handle, at: Vec, selected: boolean): Reach => ({
  hit: { part: 'handle', id: handle.id },
  away: isLine(handle)
    ? Math.min(
        distanceToLine(handle.posed, isClosed(handle.kind), at),
        selected ? distance(anchor(handle), at) : Number.POSITIVE_INFINITY,
      )
    : Number.POSITIVE_INFINITY,
});

const body = (handle: Handle, at: Vec): readonly Reach[] =>
  isLine(handle) && isClosed(handle.kind) && isInside(handle.posed, at)
    ? [{ hit: { part: 'handle', id: handle.id }, away: 0 }]
    : [];
