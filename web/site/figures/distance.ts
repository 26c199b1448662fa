/** Figure 1: the intrinsic distance from a point, beside the straight one (section III-A). */
import { mixed } from './parts/colours';
import { checkbox, legend, Numbers, pixels } from './parts/controls';
import { DragPoint } from './parts/drag_point';
import { fieldImage } from './parts/field_image';
import { figure } from './parts/figure';
import { pathLength } from './parts/paths';

/** Pixels of the picture between two isolines. */
const STEP = 40;
/** Colours fade up to here. */
const FAR = 720;
/** Circles up to here reach every point. */
const CIRCLES = Array.from({ length: 20 }, (_, index) => STEP * (index + 1));

export default figure((figure) => {
  const { ground } = figure.scene;
  const board = figure.board(
    'The gingerbread figure with lines of equal distance from a point in its left hand',
  );
  const allowed = ground.nearest.bind(ground);
  const moved = figure.ask;
  const [from, to] = [
    new DragPoint(board, { name: 'Start', kind: 'handle', at: [66, 262], allowed, moved }),
    new DragPoint(board, { name: 'End', kind: 'place', at: [158, 540], allowed, moved }),
  ];
  const numbers = new Numbers(['Path inside the shape', 'Straight line', 'Path ÷ straight line']);
  let circles = true;
  figure.stage.append(board.element);
  figure.panel.append(
    numbers.element,
    legend(
      { colour: 'blue', look: 'line', meaning: 'Equal distance inside, every 40 px' },
      { colour: 'pink', look: 'dashed', meaning: 'Equal straight distance' },
      { colour: 'ink', look: 'line', meaning: 'Shortest path' },
    ),
    checkbox('Show the circles of straight distance', circles, (on) => {
      circles = on;
      figure.draw();
    }),
  );

  let field = new Float64Array();
  let path = new Float64Array();
  let ends = [from.at, to.at] as const;
  return {
    async answer() {
      const asked = [from.at, to.at] as const;
      [field, path] = await Promise.all([
        ground.solution.distances(asked[0], ground.points),
        ground.solution.path(...asked),
      ]);
      ends = asked;
      const [[ax, ay], [bx, by]] = ends;
      const [inside, straight] = [pathLength(path), Math.hypot(bx - ax, by - ay)];
      const ratio = straight > 0 ? inside / straight : 1;
      numbers.set(pixels(inside), pixels(straight), ratio.toFixed(2));
    },
    draw() {
      if (board.scale === 0) return;
      const { blue, ink, paper, pink, shape } = figure.colours;
      const ramp = { most: FAR, at: (distance: number) => mixed(shape, blue, 0.34 * (1 - distance / FAR)) };
      const lines = { field, step: STEP, colour: blue, width: 2.4 };
      board.begin(fieldImage(board.pixels, field, ramp, [lines]));
      board.outline(ink);
      if (circles) board.circles(ends[0], CIRCLES, pink);
      board.line(ends.flat(), ink, { width: 1.5, dashed: true, casing: paper });
      board.line(path, ink, { width: 2.5, casing: paper });
    },
  };
});
