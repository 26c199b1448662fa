/** The handles that several figures share. */
import type { Point, ProjectInput } from '../../../src/core';
import { SAMPLES } from './sizes';

export interface NamedPlace {
  readonly id: string;
  readonly at: Point;
}

export const HANDLES: readonly NamedPlace[] = [
  { id: 'head', at: [256, 130] },
  { id: 'left hand', at: [62, 258] },
  { id: 'right hand', at: [450, 258] },
  { id: 'left foot', at: [156, 563] },
  { id: 'right foot', at: [356, 563] },
];

/** A project with the paper's settings, which are the defaults. */
export const projectOf = (
  handles: readonly NamedPlace[],
  settings: Exclude<ProjectInput, string> = {},
): Exclude<ProjectInput, string> => ({
  samples: SAMPLES,
  handles: handles.map(({ id, at }) => ({ id, kind: 'point', rest: at })),
  ...settings,
});
