/** The mask of stiff places: bytes in a grid of cells over the picture at rest. */
import { fromBase64, toBase64 } from './base64';
import { STIFFNESS_CELLS } from './generated/settings';
import type { Handle, ImageRef, Project, Stiffness } from './project';

/** The cells of a mask, rows from top to bottom: 0 is soft, 255 is stiff. */
export interface Cells {
  readonly width: number;
  readonly height: number;
  readonly values: Uint8Array;
}

/** Cells along the longer side of a picture. */
const MOST = STIFFNESS_CELLS;

/** The cells of a picture without stiff places, as square as they can be. */
export function softCells({ width, height }: ImageRef): Cells {
  const longer = Math.max(width, height);
  const [columns, rows] = [width, height].map((side) => Math.max(1, Math.round((MOST * side) / longer)));
  return cellsOf(columns ?? 1, rows ?? 1, () => 0);
}

function cellsOf(width: number, height: number, value: (column: number, row: number) => number): Cells {
  const values = new Uint8Array(width * height);
  for (let row = 0; row < height; row++)
    for (let column = 0; column < width; column++) values[row * width + column] = value(column, row);
  return { width, height, values };
}

/** Masks are values: each is read once. */
const read = new WeakMap<Stiffness, Uint8Array>();

/** The cells of a project's mask, as fine as {@link softCells}: a coarser mask could not hold a stroke. */
export function cellsForStrokes({ stiffness, image }: Project): Cells {
  const soft = softCells(image);
  if (!stiffness) return soft;
  const { width, height } = stiffness;
  const values = read.get(stiffness) ?? fromBase64(stiffness.values);
  read.set(stiffness, values);
  const own = { width, height, values };
  if (width === soft.width && height === soft.height) return own;
  return cellsOf(soft.width, soft.height, (column, row) =>
    Math.round(valueAt(own, (column + 0.5) / soft.width, (row + 0.5) / soft.height)),
  );
}

/** Bilinear between the centres of cells, at a place from 0 to 1 each way. */
function valueAt({ width, height, values }: Cells, x: number, y: number): number {
  const [left, right, along] = between(x, width);
  const [top, bottom, down] = between(y, height);
  const value = (column: number, row: number) => values[row * width + column] ?? 0;
  const ofRow = (row: number) => (1 - along) * value(left, row) + along * value(right, row);
  return (1 - down) * ofRow(top) + down * ofRow(bottom);
}

function between(place: number, cells: number): readonly [first: number, second: number, share: number] {
  const at = Math.min(Math.max(place * cells - 0.5, 0), cells - 1);
  const first = Math.floor(at);
  return [first, Math.min(first + 1, cells - 1), at - first];
}

/** The project with these cells. Without a stiff one it has no mask. */
export function withCells(project: Project, { width, height, values }: Cells): Project {
  if (values.every((value) => value === 0)) return withoutStiffness(project);
  const stiffness: Stiffness = { width, height, values: toBase64(values) };
  read.set(stiffness, values);
  return { ...project, stiffness };
}

export function withoutStiffness(project: Project): Project {
  const { stiffness: _, ...soft } = project;
  return soft;
}

/** The stiffness of a handle: that of a polygon, or 0. */
export const stiffnessOf = (handle: Handle): number =>
  handle.kind === 'polygon' ? (handle.stiffness ?? 0) : 0;

/** A polygon with its inside as stiff as a number from 0 to 1 says. Other handles do not change. */
export function stiffened(handle: Handle, stiffness: number): Handle {
  if (handle.kind !== 'polygon') return handle;
  const { stiffness: _, ...soft } = handle;
  const rounded = Math.round(Math.min(Math.max(stiffness, 0), 1) * 100) / 100;
  return rounded === 0 ? soft : { ...soft, stiffness: rounded };
}

/** Whether any place of the picture is stiff. */
export const isStiff = ({ stiffness, handles }: Project): boolean =>
  stiffness !== undefined || handles.some((handle) => stiffnessOf(handle) > 0);
