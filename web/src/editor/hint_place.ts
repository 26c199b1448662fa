/** The side of a handle that has room for the page's hint, and leaves the middle of the picture free. */
import { type Box, boxContains, reachesBeyond } from '../geometry/box';
import type { Vec } from '../geometry/vec';

/** The widest hint, the space between it and the middle of its handle, and around the picture's middle. CSS pixels. */
export const HINT = { widest: 190, apart: 26, clear: 12 } as const;
/** Of the type in a hint: letters, letters of East Asian scripts, lines, and the space around the text. */
const TYPE = { letter: 7.5, wide: 14, line: 20, around: [36, 20] } as const;

export interface HintPlace {
  readonly side: 'right' | 'above' | 'below' | 'left';
  /** The part of its width before the handle, for a hint above or below it. */
  readonly along: number;
}

/** The approximate size of a hint with a text, in CSS pixels. */
function sizeOf(text: string): Vec {
  const [beside, over] = TYPE.around;
  const long = [...text].reduce((sum, letter) => sum + (letter > '\u2e80' ? TYPE.wide : TYPE.letter), 0);
  const width = Math.min(long, HINT.widest - beside);
  return [width + beside, Math.ceil(long / width) * TYPE.line + over];
}

/**
 * The place of a hint. Without one, null.
 *
 * @param at the handle, CSS pixels of the stage.
 * @param free the area free of cards.
 * @param middle of the picture.
 */
export function hintPlace(text: string, [x, y]: Vec, free: Box, middle: Vec): HintPlace | null {
  const [width, height] = sizeOf(text);
  // Above or below, as near to the middle of the handle as the free area allows.
  const least = Math.max(free.min[0], Math.min(x - 0.75 * width, free.max[0] - width));
  const along = Math.max(0.1, Math.min((x - least) / width, 0.9));
  const corners = {
    right: [x + HINT.apart, y - height / 2],
    above: [x - along * width, y - HINT.apart - height],
    below: [x - along * width, y + HINT.apart],
    left: [x - HINT.apart - width, y - height / 2],
  } as const;
  for (const [side, min] of Object.entries(corners)) {
    const box = { min, max: [min[0] + width, min[1] + height] } as const;
    const { clear } = HINT;
    const around = {
      min: [min[0] - clear, min[1] - clear],
      max: [box.max[0] + clear, box.max[1] + clear],
    } as const;
    if (!reachesBeyond(box, free, 1) && !boxContains(around, middle))
      return { side: side as HintPlace['side'], along };
  }
  return null;
}
