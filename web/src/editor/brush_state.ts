/** The brush as a person has set it. */
import type { BrushKind } from '../tools/brush_kinds';

export interface BrushState {
  readonly kind: BrushKind;
  /** Diameter, in percent of the longer side of the picture. See {@link sizeOf}. */
  readonly size: number;
  /** In percent. */
  readonly strength: number;
  /** Whether a brush that stiffens erases. */
  readonly erases: boolean;
  /** What a stroke has been made with: its hint has done its work. */
  readonly used: readonly BrushKind[];
}

export const DEFAULT_BRUSH: BrushState = { kind: 'push', size: 12, strength: 100, erases: false, used: [] };

export const BRUSH_STRENGTHS = { least: 5, most: 100 } as const;

const MOST = 60;

/** A displacement is a grid of 128 intervals, which a smaller brush would slip through. */
export const brushSizes = ({
  kind,
}: Pick<BrushState, 'kind'>): { readonly least: number; readonly most: number } => ({
  least: kind === 'stiffen' ? 1 : 3,
  most: MOST,
});

/** The size that counts. */
export const sizeOf = (brush: Pick<BrushState, 'kind' | 'size'>): number =>
  Math.max(brush.size, brushSizes(brush).least);

/** Growth of the brush by a key, and the least step in percent. */
const GROWTH = 1.2;

/** The next size above or below. */
export function sizeBeside(brush: Pick<BrushState, 'kind' | 'size'>, way: 1 | -1): number {
  const size = sizeOf(brush);
  const next = way > 0 ? Math.max(size + 1, Math.round(size * GROWTH)) : Math.round(size / GROWTH);
  const smaller = way < 0 ? Math.min(size - 1, next) : next;
  const { least, most } = brushSizes(brush);
  return Math.min(Math.max(smaller, least), most);
}
