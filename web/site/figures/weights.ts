/** Figure 5: the weight of a handle with its isolines, and all weights at a point (equation 2). */
import type { PointWeights, Solution, Study } from '../../src/core';
import { mixed } from './parts/colours';
import { choice, legend, Numbers } from './parts/controls';
import { DragPoint } from './parts/drag_point';
import { fieldImage } from './parts/field_image';
import { figure } from './parts/figure';
import { HANDLES as COMMON, type NamedPlace, projectOf } from './parts/handles';
import { weightsOf } from './parts/site_weights';

/** With two handles so near to each other that Algorithm 1 adds virtual ones. */
const HANDLES: readonly NamedPlace[] = [...COMMON, { id: 'left elbow', at: [140, 268] }];

export default figure((figure) => {
  const { warper, ground } = figure.scene;
  const board = figure.board('The gingerbread figure, with the weight of the chosen handle');
  let chosen = HANDLES.length - 1;
  const probe = new DragPoint(board, {
    name: 'Point to weigh',
    kind: 'place',
    at: [200, 300],
    allowed: ground.nearest.bind(ground),
    moved: figure.ask,
  });
  const numbers = new Numbers([...HANDLES.map(({ id }) => capital(id)), 'Virtual handles', 'Sum']);
  const names = HANDLES.map(({ id }) => capital(id));
  figure.stage.append(board.element);
  figure.panel.append(
    choice('Weight of the', names, chosen, (index) => {
      chosen = index;
      figure.ask();
    }),
    numbers.element,
    legend(
      { colour: 'blue', look: 'line', meaning: 'Weight 0.1, 0.2, … 0.9' },
      { colour: 'red', look: 'line', meaning: 'The support ends: beyond, the weight is 0' },
      { colour: 'green', look: 'dot', meaning: 'Virtual handle' },
    ),
  );

  let solved: { solution: Solution; study: Study; rows: PointWeights } | null = null;
  let field = new Float64Array();
  let distances = new Float64Array();
  let radius = 0;
  let shown = chosen;

  return {
    async answer() {
      const [index, at] = [chosen, probe.at];
      solved ??= await solve();
      const { solution, study, rows } = solved;
      const site = study.sites.findIndex(({ handle }) => handle === index);
      field = weightsOf(rows, site);
      radius = study.sites[site]?.support_radius ?? Number.POSITIVE_INFINITY;
      let here: PointWeights;
      [distances, here] = await Promise.all([
        solution.distances(HANDLES[index]?.at ?? [0, 0], ground.points),
        solution.weights(Float64Array.from(at)),
      ]);
      shown = index;
      const parts = new Float64Array(HANDLES.length + 1);
      for (const [entry, site] of here.sites.entries()) {
        const handle = study.sites[site]?.handle ?? -1;
        const part = handle === -1 ? HANDLES.length : handle;
        parts[part] = (parts[part] ?? 0) + (here.weights[entry] ?? 0);
      }
      const sum = parts.reduce((sum, part) => sum + part, 0);
      numbers.set(...Array.from(parts, (part) => part.toFixed(3)), sum.toFixed(3));
    },
    draw() {
      if (board.scale === 0 || !solved) return;
      const { blue, green, ink, paper, red, shape } = figure.colours;
      const ramp = { most: 1, at: (weight: number) => mixed(shape, blue, 0.75 * weight) };
      const image = fieldImage(board.pixels, field, ramp, [
        { field, step: 0.1, most: 0.9, colour: blue, width: 1.6 },
        { field: distances, step: radius, most: radius, colour: red, width: 4 },
      ]);
      board.begin(image);
      board.outline(ink);
      for (const { rest, handle } of solved.study.sites) if (handle === -1) board.dot(rest, 3, green, paper);
      for (const [index, { at }] of HANDLES.entries()) {
        board.dot(at, index === shown ? 7 : 4, blue, paper);
      }
    },
  };

  async function solve() {
    const solution = await warper.solve(projectOf(HANDLES));
    const [study, rows] = await Promise.all([solution.study(), solution.weights(ground.points)]);
    return { solution, study, rows };
  }
});

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
