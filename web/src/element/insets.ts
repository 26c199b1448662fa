/** Room for the cards over the stage. Breakpoints as in `ui/layout.ts`, which measures the stage with its bars. */
import type { Insets, Size } from '../geometry/camera';

/** The layout that the insets depend on. */
export interface Cards {
  /** CSS pixels. */
  readonly stage: Size;
  /** Bars and buttons are sized for fingers. */
  readonly coarse: boolean;
  /** The panel is open, if the layout shows it as a sheet. */
  readonly sheet: boolean;
  /** What `play` shows without bars and cards; null in the editor. */
  readonly bare: 'handles' | 'picture' | null;
}

/** Room for a whole handle at the rim of a bare picture, and for its hit area, CSS pixels. */
const RIM = { fine: 16, coarse: 24 } as const;

/** Height of both bars together, CSS pixels. */
const BARS = { fine: 82, coarse: 98 } as const;

const even = (by: number): Insets => ({ top: by, right: by, bottom: by, left: by });

export function insetsOf({ stage: { width, height }, coarse, sheet, bare }: Cards): Insets {
  if (bare) return even(bare === 'picture' ? 0 : RIM[coarse ? 'coarse' : 'fine']);
  const whole = height + BARS[coarse ? 'coarse' : 'fine'];
  if (width >= 640 && whole < 372) return { top: 16, right: 248, bottom: 16, left: whole < 290 ? 182 : 134 };
  if (width >= 900) return { top: 28, right: 260, bottom: 28, left: 84 };
  if (width >= 640) return { top: 20, right: 248, bottom: 20, left: 72 };
  // Too low for room beside the sheet: the sheet may cover the picture.
  if (whole < 372) return { top: 8, right: 8, bottom: 8, left: !coarse ? 108 : whole < 290 ? 174 : 124 };
  return { top: 16, right: 16, bottom: sheet ? 136 : 76, left: 16 };
}
