/** Room for the cards over the stage. The breakpoints are those of `ui/layout.ts`, which are of the stage with its bars. */
import type { Insets, Size } from '../geometry/camera';

/** What the insets depend on. */
export interface Cards {
  /** CSS pixels. */
  readonly stage: Size;
  /** Bars and buttons are as wide as a finger. */
  readonly coarse: boolean;
  /** The panel is open, where it is a sheet. */
  readonly sheet: boolean;
  /** What is shown without any bars and cards. */
  readonly bare: 'handles' | 'picture' | null;
}

/** A handle at the rim of a bare picture is seen whole, and can be taken hold of. CSS pixels. */
const RIM = { fine: 16, coarse: 24 } as const;

/** What both bars take of the height, CSS pixels. */
const BARS = { fine: 82, coarse: 98 } as const;

const even = (by: number): Insets => ({ top: by, right: by, bottom: by, left: by });

export function insetsOf({ stage: { width, height }, coarse, sheet, bare }: Cards): Insets {
  if (bare) return even(bare === 'picture' ? 0 : RIM[coarse ? 'coarse' : 'fine']);
  const whole = height + BARS[coarse ? 'coarse' : 'fine'];
  if (width >= 640 && whole < 372) return { top: 16, right: 248, bottom: 16, left: whole < 290 ? 182 : 134 };
  if (width >= 900) return { top: 28, right: 260, bottom: 28, left: 84 };
  if (width >= 640) return { top: 20, right: 248, bottom: 20, left: 72 };
  // So low that a sheet may lie over the picture: beside it, nothing would be left of it.
  if (whole < 372) return { top: 8, right: 8, bottom: 8, left: !coarse ? 108 : whole < 290 ? 174 : 124 };
  return { top: 16, right: 16, bottom: sheet ? 136 : 76, left: 16 };
}
