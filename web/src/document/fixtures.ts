/** Handles for tests. */
import type { BarHandle } from './project';

/** A bar at rest, of so many pixels to the right from the origin. */
export const straightBar = (length: number): BarHandle => {
  const line = [
    [0, 0],
    [length, 0],
  ] as const;
  return { id: 'arm', kind: 'bar', rest: line, posed: line, rotation: 'auto' };
};
