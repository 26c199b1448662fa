/** Figure 3: Algorithm 1 step by step, with the curve of its score (section IV-A). */
import type { Point, Round, Solution, Study } from '../../src/core';
import { ticks } from '../../src/geometry/ticks';
import { cellColours } from './parts/cell_colours';
import { cellImage, nearestFields } from './parts/cell_image';
import { legend, pixels, Slider, sentence } from './parts/controls';
import { DragPoint } from './parts/drag_point';
import { element } from './parts/elements';
import { figure } from './parts/figure';
import { projectOf } from './parts/handles';

const START: readonly { readonly id: string; readonly at: Point }[] = [
  { id: 'first', at: [232, 330] },
  { id: 'second', at: [282, 330] },
];
/** The nearest that the two handles may come. */
const APART = 16;

export default figure((figure) => {
  const { warper, ground } = figure.scene;
  const board = figure.board(
    'The gingerbread figure with two handles, and virtual handles that Algorithm 1 has added',
  );
  const chart = figure.chart();
  const points: DragPoint[] = START.map(
    ({ id, at }, index) =>
      new DragPoint(board, {
        name: `The ${id} handle`,
        kind: 'handle',
        at,
        allowed: (to) => {
          const inside = ground.nearest(to);
          const [x, y] = (points[1 - index] as DragPoint).at;
          return Math.hypot(inside[0] - x, inside[1] - y) >= APART ? inside : (points[index] as DragPoint).at;
        },
        moved: () => figure.ask(),
      }),
  );
  let study: Study | null = null;
  const shown = (round: number) => (study ? `${round} of ${study.rounds.length}` : '');
  const slider = new Slider({ label: 'Step', range: [1, 1], step: 1, value: 1, shown, moved: figure.ask });
  const step = (text: string, by: number) => {
    const button = element('button', { type: 'button' }, text);
    button.addEventListener('click', () => {
      // A disabled button would lose the focus.
      if (button.ariaDisabled === 'true') return;
      slider.value += by;
      figure.ask();
    });
    return button;
  };
  const [back, next] = [step('Back', -1), step('Next', 1)];
  const words = sentence();
  figure.stage.append(board.element);
  figure.panel.append(
    element('div', { className: 'buttons' }, back, next),
    slider.element,
    words,
    chart.element,
    legend(
      { colour: 'blue', look: 'dot', meaning: 'Handle' },
      { colour: 'green', look: 'dot', meaning: 'Virtual handle' },
      { colour: 'pink', look: 'dot', meaning: 'Added by this step' },
    ),
  );

  let solution: Solution | null = null;
  /** The places of the handles in it. */
  let solved = '';
  /** The distances from each site that was shown, in the order of insertion. */
  let fields: Float64Array[] = [];
  let nearest: Uint16Array = new Uint16Array();
  let round: Round | null = null;

  return {
    async answer() {
      const places = points.map(({ at }, index) => ({ id: START[index]?.id ?? '', at }));
      if (!solution || !study || solved !== JSON.stringify(places)) {
        solution = await warper.solve(projectOf(places));
        study = await solution.study();
        solved = JSON.stringify(places);
        fields = [];
        slider.most = study.rounds.length;
      }
      const now = study.rounds[slider.value - 1] as Round;
      const sites = study.sites.slice(fields.length, now.sites);
      for (const { rest } of sites) fields.push(await solution.distances(rest, ground.points));
      nearest = nearestFields(fields.slice(0, now.sites), ground.points.length / 2);
      round = now;
      back.ariaDisabled = String(slider.value === 1);
      next.ariaDisabled = String(slider.value === study.rounds.length);
      words.textContent = wordsOf(study, now);
    },
    draw() {
      if (board.scale === 0 || !study || !round) return;
      drawMap(study, round);
      drawScores(study, round);
    },
  };

  function drawMap({ sites, allowed_score }: Study, { sites: count, points, score }: Round): void {
    const { colours } = figure;
    const { ink, green, paper, pink } = colours;
    board.begin(cellImage(board.pixels, fields, nearest, cellColours(colours, count), ink));
    board.outline(ink);
    for (const { path, owner, limit } of points) {
      if (score > allowed_score) board.ring((sites[owner] as { rest: Point }).rest, limit, pink);
      board.line(path.flat(), pink, { width: 2.5, casing: paper });
    }
    for (const { rest } of sites.slice(START.length, count)) board.dot(rest, 4, green, paper);
    for (const { at } of points) board.dot(at, 6, pink, paper);
  }

  function drawScores({ rounds, allowed_score }: Study, { score }: Round): void {
    const { blue, faint, ink, line, pink } = figure.colours;
    const scores = rounds.map(({ score }) => Math.max(score, -1));
    const y = [Math.min(...scores, allowed_score) - 0.08, Math.max(...scores, 0.2)] as const;
    const x = [1, Math.max(rounds.length, 2)] as const;
    const axes = {
      x,
      y,
      xTicks: ticks(x, 5).filter(Number.isInteger),
      yTicks: ticks(y, 4),
      xName: 'step',
    };
    const label = `The score of each step. This one has ${score.toFixed(2)}.`;
    chart.begin(axes, label, faint, line);
    chart.horizontal(allowed_score, 'allowed', pink);
    chart.curve(
      scores.map((score, at) => [at + 1, score]),
      blue,
    );
    chart.dot([slider.value, Math.max(score, -1)], ink);
  }
});

function wordsOf({ sites }: Study, { points, sites: count, score }: Round): string {
  const [point, ...more] = points;
  const virtual = sites.slice(0, count).filter(({ handle }) => handle === -1).length;
  if (!point) return `Done: ${virtual} virtual handles. Each cell is small enough for its support.`;
  const others = more.length > 0 ? ` So do ${more.length} equally bad ones.` : '';
  return `Score ${score.toFixed(2)}: the worst cell reaches ${pixels(point.distance)}, and may reach ${pixels(point.limit)}. Its farthest point becomes a virtual handle.${others}`;
}
