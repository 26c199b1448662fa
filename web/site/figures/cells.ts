/** Figure 2: the cells of the handles, with the cell radius r_d and the separation r_h (section III-B). */
import type { Point } from '../../src/core';
import { cellColours } from './parts/cell_colours';
import { cellImage, nearestFields } from './parts/cell_image';
import { legend, Numbers, pixels, sentence } from './parts/controls';
import { DragPoint } from './parts/drag_point';
import { element, symbol } from './parts/elements';
import { figure } from './parts/figure';
import { HANDLES } from './parts/handles';

/** Two handles closer than this have no cells that can be seen. */
const APART = 8;

/** Squares around the farthest sample, each with the gap between its points: finer and finer. */
const REFINEMENTS = [
  [12, 1],
  [1, 0.125],
] as const;

interface Far {
  readonly at: Point;
  readonly distance: number;
}

/** The cell of the chosen handle. */
interface Cell {
  readonly radius: number;
  readonly toFarthest: Float64Array;
  readonly separation: number;
  readonly toNearest: Float64Array;
}

export default figure((figure) => {
  const { ground } = figure.scene;
  const { solution, points } = ground;
  const board = figure.board('The gingerbread figure, divided into one cell for each handle');
  let chosen = 0;
  const handles: DragPoint[] = HANDLES.map(
    ({ id, at }, index) =>
      new DragPoint(board, {
        name: `Handle: ${id}`,
        kind: 'handle',
        at,
        allowed: (to) => {
          const inside = ground.nearest(to);
          const others = handles.filter((_, other) => other !== index);
          return others.every((other) => gap(other.at, inside) >= APART) ? inside : handleAt(index);
        },
        moved: figure.ask,
        chosen: () => choose(index),
      }),
  );
  const handleAt = (index: number): Point => (handles[index] as DragPoint).at;
  const choose = (index: number) => {
    if (index === chosen) return;
    chosen = index;
    press();
    figure.ask();
  };
  const press = () => {
    for (const [index, { button }] of handles.entries()) button.ariaPressed = String(index === chosen);
  };
  press();

  const numbers = new Numbers([
    element('span', {}, symbol('r', 'd'), ', to the farthest point of its cell'),
    element('span', {}, symbol('r', 'h'), ', to the nearest other handle'),
  ]);
  const verdict = sentence();
  figure.stage.append(board.element);
  figure.panel.append(
    numbers.element,
    legend(
      { colour: 'pink', look: 'line', meaning: element('span', {}, symbol('r', 'd'), ', the cell radius') },
      { colour: 'blue', look: 'line', meaning: element('span', {}, symbol('r', 'h'), ', the separation') },
    ),
    verdict,
  );

  /** The distances from each handle, with the place that they are from. */
  const known: { from: Point; field: Float64Array }[] = [];
  let fields: Float64Array[] = [];
  let nearest: Uint16Array = new Uint16Array();
  let cell: Cell | null = null;

  async function cellOf(index: number, places: readonly Point[]): Promise<Cell> {
    const from = places[index] as Point;
    const farthest = await farthestOf(index, places);
    const gaps = await solution.distances(from, Float64Array.from(places.flat()));
    gaps[index] = Number.POSITIVE_INFINITY;
    const separation = Math.min(...gaps);
    const [toFarthest, toNearest] = await Promise.all([
      solution.path(from, farthest.at),
      solution.path(from, places[gaps.indexOf(separation)] as Point),
    ]);
    return { radius: farthest.distance, toFarthest, separation, toNearest };
  }

  /** The farthest point of a cell: the farthest sample, and then better ones around it. */
  async function farthestOf(index: number, places: readonly Point[]): Promise<Far> {
    const field = fields[index] as Float64Array;
    let best: Far = { at: places[index] as Point, distance: 0 };
    for (const [point, owner] of nearest.entries()) {
      const distance = field[point] as number;
      if (owner === index && distance > best.distance) best = { at: ground.point(point), distance };
    }
    for (const [reach, step] of REFINEMENTS) {
      const around = gridAround(best.at, reach, step);
      const near = await Promise.all(places.map((from) => solution.distances(from, around)));
      for (const [point, distance] of (near[index] as Float64Array).entries()) {
        // Points outside the shape are NaN, and never farther.
        const owned = near.every((other) => (other[point] as number) >= distance);
        if (!owned || distance <= best.distance) continue;
        best = { at: [around[2 * point] as number, around[2 * point + 1] as number], distance };
      }
    }
    return best;
  }

  return {
    async answer() {
      const [index, places] = [chosen, handles.map(({ at }) => at)];
      fields = await Promise.all(
        places.map(async (from, at) => {
          const before = known[at];
          if (before && gap(before.from, from) === 0) return before.field;
          const field = await solution.distances(from, points);
          known[at] = { from, field };
          return field;
        }),
      );
      nearest = nearestFields(fields, points.length / 2);
      cell = await cellOf(index, places);
      const { radius, separation } = cell;
      numbers.set(pixels(radius), pixels(separation));
      const name = HANDLES[index]?.id;
      verdict.textContent =
        radius <= separation
          ? `Equation 3 holds for the ${name}: its support can cover the cell and end before the next handle.`
          : `Equation 3 fails for the ${name}: a support that covers the cell would reach the next handle. Figure 3 mends that.`;
    },
    draw() {
      if (board.scale === 0 || !cell) return;
      const { blue, ink, paper, pink } = figure.colours;
      const colours = cellColours(figure.colours, fields.length, chosen);
      board.begin(cellImage(board.pixels, fields, nearest, colours, ink));
      board.outline(ink);
      board.line(cell.toFarthest, pink, { width: 3, casing: paper });
      board.line(cell.toNearest, blue, { width: 3, casing: paper });
    },
  };
});

/** The points of a square grid. @param reach Half of the side. */
function gridAround([x, y]: Point, reach: number, step: number): Float64Array<ArrayBuffer> {
  const steps = Math.round((2 * reach) / step) + 1;
  const grid = new Float64Array(2 * steps * steps);
  for (let at = 0; at < steps * steps; at++) {
    grid[2 * at] = x - reach + step * (at % steps);
    grid[2 * at + 1] = y - reach + step * Math.floor(at / steps);
  }
  return grid;
}

const gap = ([ax, ay]: Point, [bx, by]: Point): number => Math.hypot(bx - ax, by - ay);
