/** Texts for screen readers: labels of handles, and announcements. */
import type { Texts } from '../texts';
import { plural } from './language';

const rotation = (degrees: number): string =>
  `giro de ${degrees} ${plural(Math.abs(degrees), { one: 'grado', other: 'grados' })}`;

const says = (name: string, kind: string): boolean => name.toLowerCase().split(' ').includes(kind);

export const spoken: Texts['spoken'] = {
  point: (name) => (says(name, 'punto') ? name : `Punto de control ${name}`),
  bar: (name, corners) =>
    says(name, 'barra')
      ? `${name}, con ${corners} esquinas`
      : `Punto de control ${name}, barra con ${corners} esquinas`,
  polygon: (name, corners) =>
    says(name, 'polígono')
      ? `${name}, con ${corners} esquinas`
      : `Punto de control ${name}, polígono con ${corners} esquinas`,
  x: (x) => `x ${x}`,
  y: (y) => `y ${y}`,
  rotation,
  scale: (scale) => `escala ${scale}`,
  depth: (depth) => `orden ${depth}`,
  behind: 'detrás de otra parte',
  corner: (corner, handle, x, y) => `Esquina ${corner} de ${handle}, x ${x}, y ${y}`,

  place: (handles, x, y, degrees, scale) =>
    `${handles}: x ${x}, y ${y}, ${rotation(degrees)}${scale === null ? '' : `, escala ${scale}`}`,
  time: (time) => time,
  at: (x, y) => `x ${x}, y ${y}`,
  cornerAt: (corner, handle, x, y) => `Esquina ${corner} de ${handle}: x ${x}, y ${y}`,
  selectionCornerAt: (corner, x, y) => `Esquina ${corner} de la selección: x ${x}, y ${y}`,
  depthOf: (handle, depth) => `${handle}: orden ${depth}`,
  depthInFront: (handle, depth) => `${handle}: orden ${depth}, delante`,
  depthAtBack: (handle, depth) => `${handle}: orden ${depth}, al fondo`,
  draft: {
    bar: (corner, x, y) => `barra, esquina ${corner}: x ${x}, y ${y}`,
    polygon: (corner, x, y) => `polígono, esquina ${corner}: x ${x}, y ${y}`,
    lasso: (corner, x, y) => `lazo, esquina ${corner}: x ${x}, y ${y}`,
  },
  drawingGivenUp: 'Dibujo cancelado',
  stepAt: (step, place) => `${step}. ${place}`,
  undone: (step) => `Deshecho: ${step}`,
  redone: (step) => `Rehecho: ${step}`,
  selected: (handles) => `Selección: ${handles}`,
  copiedPose: (handles) => `Pose copiada: ${handles}`,
  cancelled: 'Cancelado',
  stoppedAtFold: 'Detenido antes de que la imagen se pliegue',
  held: 'Agarrado. Las flechas empujan, Intro suelta',
  cornerCrosses: 'El contorno se cruzaría consigo mismo',
  cornerStays: 'El contorno necesita esta esquina',
  brushSize: (percent) => `Tamaño del pincel: ${percent} por ciento`,
  brush: {
    push: 'Pincel: empujar',
    pinch: 'Pincel: contraer',
    bloat: 'Pincel: inflar',
    smooth: 'Pincel: suavizar',
    restore: 'Pincel: restaurar',
    stiffen: 'Pincel: endurecer',
    paints: 'Pincel: pintar rigidez',
    erases: 'Pincel: borrar rigidez',
  },
  pictureOpen: (name) => `Imagen abierta: ${name}`,
  toolAndPicture: (tool, picture) => `${tool}, imagen abierta: ${picture}`,
  timelineOpen: 'Línea de tiempo',
  timelineClosed: 'Línea de tiempo cerrada',
  exporting: (percent) => `Exportando, ${percent} por ciento`,
  exportCancelled: 'Exportación cancelada',
};
