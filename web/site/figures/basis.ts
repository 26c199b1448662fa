/** Figure 4: the basis φ by its degree n and the shape factor α (equations 3 and 5), and the weight from it. */
import type { SiteStudy } from '../../src/core';
import { ticks } from '../../src/geometry/ticks';
import { mixed } from './parts/colours';
import { Numbers, pixels, Slider } from './parts/controls';
import { element, symbol } from './parts/elements';
import { fieldImage } from './parts/field_image';
import { figure } from './parts/figure';
import { HANDLES, projectOf } from './parts/handles';
import { weightsOf } from './parts/site_weights';

/** The handle whose weight is shown: the head. */
const SHOWN = 0;

export default figure((figure) => {
  const { warper, ground } = figure.scene;
  const board = figure.board('The gingerbread figure, with the weight of the handle in its head');
  const chart = figure.chart();
  const moved = figure.ask;
  const degree = new Slider({ label: 'Degree n', range: [5, 20], step: 1, value: 5, moved });
  const alpha = new Slider({
    label: 'Shape factor α',
    range: [0, 1],
    step: 0.05,
    value: 1,
    shown: (value) => value.toFixed(2),
    moved,
  });
  const numbers = new Numbers([
    element('span', {}, 'Cell radius ', symbol('r', 'd')),
    element('span', {}, 'Support radius ', symbol('r', 'i')),
    element('span', {}, 'Separation ', symbol('r', 'h')),
  ]);
  figure.stage.append(board.element);
  figure.panel.append(degree.element, alpha.element, chart.element, numbers.element);

  let site: SiteStudy | null = null;
  let falloff: readonly number[] = [];
  let field = new Float64Array();

  return {
    async answer() {
      const weighting = { degree: degree.value, shape_factor: alpha.value };
      const solution = await warper.solve(projectOf(HANDLES, { weighting }));
      const [study, rows] = await Promise.all([solution.study(), solution.weights(ground.points)]);
      const index = study.sites.findIndex(({ handle }) => handle === SHOWN);
      site = study.sites[index] ?? null;
      falloff = study.falloff;
      field = weightsOf(rows, index);
      const lengths = [site?.cell_radius, site?.support_radius, site?.separation];
      numbers.set(...lengths.map((length) => pixels(length ?? Number.NaN)));
    },
    draw() {
      if (board.scale === 0 || !site) return;
      const { blue, ink, shape } = figure.colours;
      const ramp = { most: 1, at: (weight: number) => mixed(shape, blue, 0.75 * weight) };
      const lines = { field, step: 0.1, most: 0.9, colour: blue, width: 1.6 };
      board.begin(fieldImage(board.pixels, field, ramp, [lines]));
      board.outline(ink);
      board.dot(HANDLES[SHOWN]?.at ?? [0, 0], 6, blue, figure.colours.paper);
      drawCurve(site);
    },
  };

  function drawCurve({ cell_radius, separation, support_radius, support_range }: SiteStudy): void {
    const { blue, faint, green, ink, line, pink } = figure.colours;
    const radius = support_radius ?? 0;
    const most = 1.12 * Math.max(radius, cell_radius, separation ?? 0, ...support_range);
    const axes = {
      x: [0, most] as const,
      y: [0, 1] as const,
      xTicks: ticks([0, most], 4),
      yTicks: [0, 0.5, 1],
      xName: 'distance d, px',
    };
    chart.begin(axes, `φ falls from 1 to 0 at ${pixels(radius)}.`, faint, line);
    const last = falloff.length - 1;
    chart.curve(
      [...falloff.map((value, at) => [(radius * at) / last, value] as const), [most, 0]],
      blue,
      true,
    );
    chart.radius(cell_radius, 'd', pink, 0);
    chart.radius(radius, 'i', ink, 2);
    if (separation !== null) chart.radius(separation, 'h', green, 1);
  }
});
