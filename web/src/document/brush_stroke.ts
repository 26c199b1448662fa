/**
 * A stroke of the brush over the cells of a mask.
 *
 * It counts once at each place, however often it goes over it and however often the pointer reports: its cover is the
 * greatest along its way. Strokes add up.
 */
import { distance, subtract, type Vec } from '../geometry/vec';
import type { ImageRef, Project } from './project';
import { type Cells, cellsForStrokes, withCells } from './stiffness';

/** A round brush with a soft rim. */
export interface Brush {
  /** Image pixels of the picture at rest. */
  readonly radius: number;
  /** How much of the way to stiff, or back to soft, one stroke goes: from 0 to 1. */
  readonly strength: number;
  readonly erases: boolean;
}

export interface Stroke {
  readonly project: Project;
  readonly brush: Brush;
  readonly before: Cells;
  /** How much of the stroke covers each cell, from 0 to 1. */
  readonly cover: Float32Array;
}

/** The part of the radius within which the brush covers fully. */
const CORE = 0.4;

export function beginStroke(project: Project, brush: Brush): Stroke {
  const before = cellsForStrokes(project);
  return { project, brush, before, cover: new Float32Array(before.values.length) };
}

/** The stroke, led on straight between two places of the picture at rest. */
export function ledStroke(stroke: Stroke, from: Vec, to: Vec): Stroke {
  const { before, brush, project } = stroke;
  const cover = stroke.cover.slice();
  const [columns, rows] = [0, 1].map((axis) => reached(stroke, axis, from, to)) as [Range, Range];
  for (let row = rows[0]; row < rows[1]; row++)
    for (let column = columns[0]; column < columns[1]; column++) {
      const at = row * before.width + column;
      const away = distanceTo(centreOf(before, project.image, column, row), from, to);
      cover[at] = Math.max(cover[at] ?? 0, coverAt(away / brush.radius));
    }
  return { ...stroke, cover };
}

type Range = readonly [from: number, to: number];

/** The columns or rows that a line may cover. */
function reached({ before, brush, project }: Stroke, axis: number, from: Vec, to: Vec): Range {
  const [cells, side] =
    axis === 0 ? [before.width, project.image.width] : [before.height, project.image.height];
  const [a, b] = [from[axis] ?? 0, to[axis] ?? 0];
  const within = (cell: number) => Math.min(Math.max(cell, 0), cells);
  const least = within(Math.floor(((Math.min(a, b) - brush.radius) * cells) / side));
  return [least, within(Math.ceil(((Math.max(a, b) + brush.radius) * cells) / side))];
}

const centreOf = ({ width, height }: Cells, image: ImageRef, column: number, row: number): Vec => [
  ((column + 0.5) * image.width) / width,
  ((row + 0.5) * image.height) / height,
];

function distanceTo(p: Vec, from: Vec, to: Vec): number {
  const [along, away] = [subtract(to, from), subtract(p, from)];
  const square = along[0] ** 2 + along[1] ** 2;
  const share =
    square === 0 ? 0 : Math.min(Math.max((along[0] * away[0] + along[1] * away[1]) / square, 0), 1);
  return distance(away, [along[0] * share, along[1] * share]);
}

/** Full in the core, then smooth down to 0 at the radius. */
function coverAt(away: number): number {
  const left = Math.min(Math.max((1 - away) / (1 - CORE), 0), 1);
  return left * left * (3 - 2 * left);
}

/** The project with the changes of the stroke. */
export function withStroke({ project, brush, before, cover }: Stroke): Project {
  const { strength, erases } = brush;
  const values = before.values.map((value, at) => {
    const share = strength * (cover[at] ?? 0);
    // Down to whole numbers: weak strokes must come to 0 in the end.
    return erases ? Math.floor(value * (1 - share)) : Math.round(value + (255 - value) * share);
  });
  return withCells(project, { ...before, values });
}
