/**
 * The stacking order within the editor, from back to front.
 *
 * The stage and its bubble have no number and lie below all others. Of equal numbers, the later one in the template is
 * in front.
 */
export const ORDER = {
  panel: 1,
  tools: 2,
  status: 2,
  floating: 2,
  toolbar: 3,
  progress: 3,
  /** The panel, if it does not fit beside the tools. */
  panelOverTools: 3,
  tooltip: 4,
} as const;
