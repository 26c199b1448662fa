/** Handles for tests. */
import type { BarHandle } from './project';

/** A bar at rest, from the origin to the right. Its length is in pixels. */
export const straightBar = (length: number): BarHandle => {
  const line = [
    [0, 0],
    [length, 0],
  ] as const;
  return { id: 'arm', kind: 'bar', rest: line, posed: line, rotation: 'auto' };
};
