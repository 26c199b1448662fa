/** Texts for screen readers: labels of handles, and announcements. */
import type { Texts } from '../texts';
import { counted, plural } from './language';

const rotation = (degrees: number): string =>
  `rotation ${degrees} ${plural(Math.abs(degrees), { one: 'degré', other: 'degrés' })}`;

const says = (name: string, kind: string): boolean => name.toLowerCase().split(' ').includes(kind);

export const spoken: Texts['spoken'] = {
  point: (name) => (says(name, 'poignée') || says(name, 'point') ? name : `Poignée ${name}`),
  bar: (name, corners) =>
    says(name, 'barre')
      ? `${name}, à ${counted(corners, 'sommet')}`
      : `Poignée ${name}, barre à ${counted(corners, 'sommet')}`,
  polygon: (name, corners) =>
    says(name, 'polygone')
      ? `${name}, à ${counted(corners, 'sommet')}`
      : `Poignée ${name}, polygone à ${counted(corners, 'sommet')}`,
  x: (x) => `x ${x}`,
  y: (y) => `y ${y}`,
  rotation,
  scale: (scale) => `échelle ${scale}`,
  depth: (depth) => `plan ${depth}`,
  behind: 'derrière une autre partie',
  corner: (corner, handle, x, y) => `${handle}, sommet ${corner}, x ${x}, y ${y}`,

  place: (handles, x, y, degrees, scale) =>
    `${handles} : x ${x}, y ${y}, ${rotation(degrees)}${scale === null ? '' : `, échelle ${scale}`}`,
  time: (time) => time,
  at: (x, y) => `x ${x}, y ${y}`,
  cornerAt: (corner, handle, x, y) => `${handle}, sommet ${corner} : x ${x}, y ${y}`,
  selectionCornerAt: (corner, x, y) => `Sommet ${corner} de la sélection : x ${x}, y ${y}`,
  depthOf: (handle, depth) => `${handle} : plan ${depth}`,
  depthInFront: (handle, depth) => `${handle} : plan ${depth}, à l’avant`,
  depthAtBack: (handle, depth) => `${handle} : plan ${depth}, à l’arrière`,
  draft: {
    bar: (corner, x, y) => `barre, sommet ${corner} : x ${x}, y ${y}`,
    polygon: (corner, x, y) => `polygone, sommet ${corner} : x ${x}, y ${y}`,
    lasso: (corner, x, y) => `lasso, sommet ${corner} : x ${x}, y ${y}`,
  },
  drawingGivenUp: 'Tracé annulé',
  stepAt: (step, place) => `${step}. ${place}`,
  undone: (step) => `Annulé : ${step}`,
  redone: (step) => `Rétabli : ${step}`,
  selected: (handles) => `Sélection : ${handles}`,
  copiedPose: (handles) => `Pose copiée : ${handles}`,
  cancelled: 'Annulé',
  stoppedAtFold: 'Arrêté avant que l’image se replie',
  held: 'Saisi. Les flèches poussent, Entrée relâche',
  cornerCrosses: 'Le contour se croiserait lui-même',
  cornerStays: 'Le contour a besoin de ce sommet',
  brushSize: (percent) => `Taille du pinceau ${percent} pour cent`,
  brush: {
    push: 'Pinceau : pousser',
    pinch: 'Pinceau : pincer',
    bloat: 'Pinceau : gonfler',
    smooth: 'Pinceau : lisser',
    restore: 'Pinceau : restaurer',
    stiffen: 'Pinceau : raidir',
    paints: 'Pinceau : peindre la rigidité',
    erases: 'Pinceau : effacer la rigidité',
  },
  pictureOpen: (name) => `Image ouverte : ${name}`,
  toolAndPicture: (tool, picture) => `${tool}, image ouverte : ${picture}`,
  timelineOpen: 'Chronologie',
  timelineClosed: 'Chronologie fermée',
  exporting: (percent) => `Export, ${percent} pour cent`,
  exportCancelled: 'Export annulé',
};
