/** The effects of the brush, and those with Alt. */
import { DISPLACING } from '../document/displacing_stroke';

export const BRUSH_KINDS = [...DISPLACING, 'stiffen'] as const;
export type BrushKind = (typeof BRUSH_KINDS)[number];

/** The brush in hand. */
export interface ToolBrush {
  readonly kind: BrushKind;
  /** Image pixels of the picture at rest. */
  readonly radius: number;
  /** From 0 to 1. */
  readonly strength: number;
  /** Whether one that stiffens erases. */
  readonly erases: boolean;
}

const OPPOSITES: Partial<Readonly<Record<BrushKind, BrushKind>>> = {
  push: 'restore',
  restore: 'push',
  pinch: 'bloat',
  bloat: 'pinch',
};

/** The brush while Alt is pressed. Smoothing has no opposite. */
export const oppositeBrush = <B extends Pick<ToolBrush, 'kind' | 'erases'>>(brush: B): B =>
  brush.kind === 'stiffen'
    ? { ...brush, erases: !brush.erases }
    : { ...brush, kind: OPPOSITES[brush.kind] ?? brush.kind };
