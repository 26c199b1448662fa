/** The brush as a person has set it. */

export interface BrushState {
  /** Diameter, in percent of the longer side of the picture. */
  readonly size: number;
  /** In percent. */
  readonly strength: number;
  readonly erases: boolean;
}

export const DEFAULT_BRUSH: BrushState = { size: 12, strength: 100, erases: false };

export const BRUSH_SIZES = { least: 1, most: 60 } as const;
export const BRUSH_STRENGTHS = { least: 5, most: 100 } as const;

/** Growth of the brush by a key, and the least step in percent. */
const GROWTH = 1.2;

/** The next size above or below. */
export function sizeBeside(size: number, way: 1 | -1): number {
  const next = way > 0 ? Math.max(size + 1, Math.round(size * GROWTH)) : Math.round(size / GROWTH);
  const smaller = way < 0 ? Math.min(size - 1, next) : next;
  return Math.min(Math.max(smaller, BRUSH_SIZES.least), BRUSH_SIZES.most);
}
