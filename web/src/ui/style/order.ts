/**
 * What lies over what within the editor, from back to front. The stage has no number and lies below all of them, with the bubble that
 * belongs to it; of equal ones the later in the template is in front.
 */
export const ORDER = {
  panel: 1,
  tools: 2,
  status: 2,
  floating: 2,
  toolbar: 3,
  progress: 3,
  /** The panel where there is no room beside the tools. */
  panelOverTools: 3,
  tooltip: 4,
} as const;
