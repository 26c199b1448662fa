/** Sizes that the style sheets and the code share, CSS pixels. */

/** The layout changes if the element is narrower or lower than this. See `layouts.ts`. */
export const NARROW = 900;
export const PHONE = 640;
export const LOW = { wide: 416, phone: 372 } as const;
export const LOWEST = 316;
/** Hints are short if the element is lower than this. On phones, an on-screen keyboard leaves no more. */
export const LOW_HINTS = 460;

/** The element is no lower than this, unless the page says so. */
export const LEAST_HEIGHT = 240;

/** Default height of the editor: enough for a picture between the bars. */
export const OWN_HEIGHT = 480;

/** Width of the element if the page sizes it by content, as in a flex row. */
export const OWN_WIDTH = 320;

/** Heights of the toolbar and the status line, for mouse and touch. */
export const BARS = {
  fine: { toolbar: 48, status: 34 },
  coarse: { toolbar: 52, status: 46 },
} as const;

/** Width of the tool card with the space around it. */
export const TOOLS = {
  wide: 84,
  narrow: 72,
  low: { fine: 134, coarse: 134 },
  lowest: { fine: 198, coarse: 230 },
  lowPhone: { fine: 108, coarse: 124 },
  lowestPhone: { fine: 108, coarse: 174 },
} as const;

/** Width of the panel with the space around it. */
export const PANEL = { wide: 260, narrow: 248 } as const;

/** Width of the study card with the space around it, and its share of the height of a phone. */
export const STUDY = { wide: 360, share: 0.52 } as const;

/**
 * Heights of the sheet on phones: one line, numbers, numbers with those of a corner, settings. The share of the stage
 * is the greatest, in percent.
 */
export const SHEET = { line: 62, numbers: 160, ofCorner: 250, tall: 236, share: 46, top: 12 } as const;

/** Above an open timeline, tools have two columns if the element is lower than this, or four. */
export const OVER_TIMELINE = { low: 640, lowest: 490 } as const;

/** The height of the timeline for mouse and touch, and its greatest share of the editor's height in percent. */
export const TIMELINE = { height: 226, coarse: 270, share: 42 } as const;

/** Distances from the bottom of the stage on phones: to the sheet, and to the area clear of the tools. */
export const FROM_BOTTOM = { sheet: 74, aboveTools: 76 } as const;
