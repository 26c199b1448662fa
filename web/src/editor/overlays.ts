/** The overlays that can be drawn over the picture. */
export const OVERLAYS = [
  'mesh',
  'cells',
  'sites',
  'graph',
  'creases',
  'reach',
  'coverage',
  'stiffness',
] as const;
export type OverlayName = (typeof OVERLAYS)[number];
export type OverlayFlags = Readonly<Record<OverlayName, boolean>>;

export const NO_OVERLAYS = Object.fromEntries(OVERLAYS.map((name) => [name, false])) as OverlayFlags;
