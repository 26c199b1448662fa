import type { Texts } from '../texts';

const rotation = (degrees: number): string => `Drehung ${degrees} Grad`;

const says = (name: string, kind: string): boolean => name.toLowerCase().split(' ').includes(kind);

export const spoken: Texts['spoken'] = {
  point: (name) => (says(name, 'griff') || says(name, 'punkt') ? name : `Griff ${name}`),
  bar: (name, corners) =>
    says(name, 'stab') ? `${name}, mit ${corners} Ecken` : `Griff ${name}, Stab mit ${corners} Ecken`,
  polygon: (name, corners) =>
    says(name, 'polygon') ? `${name}, mit ${corners} Ecken` : `Griff ${name}, Polygon mit ${corners} Ecken`,
  x: (x) => `x ${x}`,
  y: (y) => `y ${y}`,
  rotation,
  scale: (scale) => `Skalierung ${scale}`,
  depth: (depth) => `Tiefe ${depth}`,
  behind: 'hinter einem anderen Teil',
  corner: (corner, handle, x, y) => `Ecke ${corner} von ${handle}, x ${x}, y ${y}`,

  place: (handles, x, y, degrees, scale) =>
    `${handles}: x ${x}, y ${y}, ${rotation(degrees)}${scale === null ? '' : `, Skalierung ${scale}`}`,
  time: (time) => time,
  at: (x, y) => `x ${x}, y ${y}`,
  cornerAt: (corner, handle, x, y) => `Ecke ${corner} von ${handle}: x ${x}, y ${y}`,
  selectionCornerAt: (corner, x, y) => `Ecke ${corner} der Auswahl: x ${x}, y ${y}`,
  depthOf: (handle, depth) => `${handle}: Tiefe ${depth}`,
  depthInFront: (handle, depth) => `${handle}: Tiefe ${depth}, ganz vorn`,
  depthAtBack: (handle, depth) => `${handle}: Tiefe ${depth}, ganz hinten`,
  draft: {
    bar: (corner, x, y) => `Stab, Ecke ${corner}: x ${x}, y ${y}`,
    polygon: (corner, x, y) => `Polygon, Ecke ${corner}: x ${x}, y ${y}`,
    lasso: (corner, x, y) => `Lasso, Ecke ${corner}: x ${x}, y ${y}`,
  },
  drawingGivenUp: 'Zeichnung verworfen',
  stepAt: (step, place) => `${step}. ${place}`,
  undone: (step) => `Rückgängig gemacht: ${step}`,
  redone: (step) => `Wiederholt: ${step}`,
  selected: (handles) => `Ausgewählt: ${handles}`,
  copiedPose: (handles) => `Pose kopiert: ${handles}`,
  cancelled: 'Abgebrochen',
  stoppedAtFold: 'Angehalten, bevor sich das Bild faltet',
  held: 'Gegriffen. Pfeiltasten schieben, Eingabe lässt los',
  cornerCrosses: 'Der Umriss würde sich selbst kreuzen',
  cornerStays: 'Der Umriss braucht diese Ecke',
  brushSize: (percent) => `Pinselgröße ${percent} Prozent`,
  brush: {
    push: 'Pinsel: schieben',
    pinch: 'Pinsel: stauchen',
    bloat: 'Pinsel: aufblähen',
    smooth: 'Pinsel: glätten',
    restore: 'Pinsel: Striche entfernen',
    stiffen: 'Pinsel: versteifen',
    paints: 'Pinsel: Steifigkeit malen',
    erases: 'Pinsel: Steifigkeit radieren',
  },
  pictureOpen: (name) => `${name} ist geöffnet`,
  toolAndPicture: (tool, picture) => `${tool}, ${picture} ist geöffnet`,
  timelineOpen: 'Zeitleiste',
  timelineClosed: 'Zeitleiste geschlossen',
  exporting: (percent) => `Export läuft, ${percent} Prozent`,
  exportCancelled: 'Export abgebrochen',
};
