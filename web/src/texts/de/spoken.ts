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
  stoppedAtFold: 'Angehalten: weiter würde das Bild sich falten',
  held: 'Gehalten. Pfeile schieben, Eingabe lässt los',
  cornerCrosses: 'Der Umriss würde sich dort selbst kreuzen',
  cornerStays: 'Der Umriss braucht diese Ecke',
  brushSize: (percent) => `Pinselgröße ${percent} Prozent`,
  brush: {
    push: 'Der Pinsel schiebt',
    pinch: 'Der Pinsel staucht',
    bloat: 'Der Pinsel bläht auf',
    smooth: 'Der Pinsel glättet',
    restore: 'Der Pinsel hebt Striche auf',
    stiffen: 'Der Pinsel versteift',
    paints: 'Der Pinsel malt',
    erases: 'Der Pinsel radiert',
  },
  pictureOpen: (name) => `${name} ist offen`,
  toolAndPicture: (tool, picture) => `${tool}, ${picture} ist offen`,
  timelineOpen: 'Zeitleiste',
  timelineClosed: 'Zeitleiste geschlossen',
  exporting: (percent) => `Export läuft, ${percent} Prozent`,
  exportCancelled: 'Der Export wurde abgebrochen',
};
