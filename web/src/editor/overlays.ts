/** The overlays that can be drawn over the picture. */
export const OVERLAYS = [
  'selection',
  'mesh',
  'sites',
  'cells',
  'graph',
  'creases',
  'reach',
  'coverage',
  'stiffness',
] as const;
export type OverlayName = (typeof OVERLAYS)[number];
export type OverlayFlags = Readonly<Record<OverlayName, boolean>>;

export const NO_OVERLAYS = Object.fromEntries(OVERLAYS.map((name) => [name, false])) as OverlayFlags;

/** At first only the selection is shown: the part that a lasso lets bend. */
export const FIRST_OVERLAYS: OverlayFlags = { ...NO_OVERLAYS, selection: true };
