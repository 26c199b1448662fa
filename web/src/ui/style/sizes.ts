/** Sizes that both the style sheets and the code go by, CSS pixels. */

/** The layout changes where the whole element is narrower or lower than this. See `layouts.ts`. */
export const NARROW = 900;
export const PHONE = 640;
export const LOW = { wide: 416, phone: 372 } as const;
export const LOWEST = 316;

/** Height of an element whose page sets none, unless the picture says otherwise. */
export const LEAST_HEIGHT = 240;

/** Width of an element whose layout leaves it to the content, as in a row of a flex box. */
export const OWN_WIDTH = 320;

/** Heights of the bar above and of the line below, for a mouse and for fingers. */
export const BARS = {
  fine: { toolbar: 48, status: 34 },
  coarse: { toolbar: 52, status: 46 },
} as const;

/** What the card of tools takes of the width, with the space around it. */
export const TOOLS = {
  wide: 84,
  narrow: 72,
  low: 134,
  lowest: 182,
  lowPhone: { fine: 108, coarse: 124 },
  lowestPhone: { fine: 108, coarse: 174 },
} as const;

/** What the panel takes of the width, with the space around it. */
export const PANEL = { wide: 260, narrow: 248 } as const;

/** On a phone, the heights of the sheet: of one line, of numbers, of numbers with those of a corner; and where it begins at the top. */
export const SHEET = { line: 62, numbers: 160, ofCorner: 250, top: 12 } as const;

/** On a phone, from the bottom of the stage: where the sheet begins, and what is clear of the tools. */
export const FROM_BOTTOM = { sheet: 74, aboveTools: 76 } as const;
