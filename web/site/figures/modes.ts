/** Figure 6: one drag, posed by the harmonic fields of the paper (equation 4) and by the rigid mode. */
import type { Point, PosedMesh, PosedSolution, Solution, WarpedPicture, Warper } from '../../src/core';
import { legend, Numbers } from './parts/controls';
import { DragPoint } from './parts/drag_point';
import { element } from './parts/elements';
import { figure } from './parts/figure';
import { HANDLES, projectOf } from './parts/handles';
import { SIZE } from './parts/sizes';

/** The hand that is dragged: on the right of the picture. */
const HAND = HANDLES[2] as (typeof HANDLES)[number];

/** The settings of new projects in the editor, apart from the mode. */
const SETTINGS = { weighting: { support: 'smooth' }, edges: true } as const;
const DENSITY = 150;

const MODES = [
  { mode: 'harmonic', title: 'The paper’s mode' },
  { mode: 'rigid', title: 'Rigid mode' },
] as const;

interface Drawn {
  readonly picture: WarpedPicture;
  /** The posed corners of triangles that are turned over. */
  readonly folds: readonly (readonly number[])[];
}

export default figure((figure) => {
  const { warper } = figure.scene;
  let at: Point = [300, 330];
  const sides = MODES.map(({ mode, title }) => {
    const board = figure.board(`The gingerbread figure. ${title}`, figure.ask);
    const point = new DragPoint(board, {
      name: `Right hand. ${title}`,
      kind: 'handle',
      at,
      allowed: ([x, y]) => [clamped(x, SIZE.width), clamped(y, SIZE.height)],
      moved: () => {
        at = point.at;
        for (const side of sides) side.point.at = at;
        figure.ask();
      },
    });
    const view = element('div', {}, element('p', { className: 'title' }, title), board.element);
    return { board, mode, point, view };
  });
  const numbers = new Numbers(MODES.map(({ title }) => `${title}: folded triangles`));
  figure.stage.append(...sides.map(({ view }) => view));
  figure.panel.append(
    numbers.element,
    legend({ colour: 'red', look: 'area', meaning: 'Folded over: the picture lies on its face here' }),
  );

  let solutions: readonly Solution[] | undefined;
  let drawn: readonly Drawn[] = [];

  return {
    async answer() {
      if (sides.some(({ board }) => board.scale === 0)) return;
      solutions ??= await solve();
      const scales = sides.map(({ board }) => board.scale);
      drawn = await Promise.all(
        solutions.map((solution, index) =>
          draw(solution.pose({ [HAND.id]: { posed: at, depth: 1 } }), scales[index] as number),
        ),
      );
      numbers.set(...drawn.map(({ folds }) => String(folds.length)));
    },
    draw() {
      for (const [index, { board }] of sides.entries()) {
        const shown = drawn[index];
        if (!shown) continue;
        const { image, origin } = shown.picture;
        board.begin(image, [-origin[0], -origin[1]]);
        board.triangles(shown.folds, figure.colours.red);
      }
    },
  };

  async function solve(): Promise<readonly Solution[]> {
    const warpers: readonly Warper[] = [await figure.scene.second(), warper];
    return Promise.all(
      sides.map(({ mode }, index) => {
        const project = projectOf(HANDLES, { ...SETTINGS, pose: { mode, density: DENSITY } });
        // Handles of the rigid mode turn automatically, as in the editor. In the paper, people turn them.
        const handles = project.handles?.map((handle) => ({
          ...handle,
          rotation: mode === 'rigid' ? ('auto' as const) : 0,
        }));
        return (warpers[index] as Warper).solve({ ...project, ...(handles && { handles }) });
      }),
    );
  }

  async function draw(posed: PosedSolution, scale: number): Promise<Drawn> {
    const [picture, mesh] = await Promise.all([posed.warp({ scale, area: 'grown' }), posed.mesh()]);
    return { picture, folds: cornersOf(mesh) };
  }
});

function cornersOf({ positions, folds }: PosedMesh): number[][] {
  const corners: number[][] = [];
  for (let at = 0; at < folds.length; at += 3) {
    const vertices = Array.from(folds.subarray(at, at + 3));
    corners.push(vertices.flatMap((vertex) => Array.from(positions.subarray(2 * vertex, 2 * vertex + 2))));
  }
  return corners;
}

const clamped = (value: number, size: number): number => Math.min(Math.max(value, 12), size - 12);
