/** The lens as a figure to be saved: the shape with the paths to the handles, the weights, and the falloff. */

import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import type { LensModel } from '../../editor/lens_model';
import { percent, siteName } from '../../editor/lens_words';
import type { Texts } from '../../texts/texts';
import { worded } from '../../texts/wording';
import { falloffChart, falloffTitle } from './falloff_figure';
import { type Drawn, pathOf, pixels } from './figure';
import { figureKey } from './figure_key';
import { mapFrame, shape, siteDots } from './map_figure';

const MAP = { width: 460, height: 560 } as const;
const GAP = 24;
/** The column of the weights: its width, and where names, bars and numbers are in it. */
const COLUMN = { width: 340, bar: 120, barWidth: 130, number: 258, top: 22 } as const;
const ROW = 26;
const FALLOFF_HEIGHT = 216;

export function lensFigure(shown: LensModel, texts: Texts): Drawn {
  const { lens, study } = shown;
  const frame = mapFrame(study.outline.flat(), MAP.width, MAP.height);
  const [x, y] = frame.place(lens.at);
  const column = weightsColumn(shown, texts);
  const content = svg`${shape(study.outline, frame)}
    ${lens.shares.map(({ path }) => svg`<path class="way" d=${pathOf(path.map(frame.place))}/>`)}
    ${siteDots(
      study.sites.map(({ rest }) => frame.place(rest)),
      study.sites.map(({ handle }) => handle),
    )}
    <circle class="glass" cx=${x} cy=${y} r="11"/><path class="aim" d="M${x - 4} ${y}h8M${x} ${y - 4}v8"/>
    <g transform="translate(${MAP.width + GAP} ${COLUMN.top})">${column.content}</g>`;
  const height = Math.max(frame.height, COLUMN.top + column.height);
  return { content, width: MAP.width + COLUMN.width + 2 * GAP, height };
}

/** The weights and the falloff, below each other. */
function weightsColumn({ lens, project, falloff }: LensModel, texts: Texts): Drawn {
  const { width } = COLUMN;
  const { lens: words } = texts;
  const [x = 0, y = 0] = lens.at.map(Math.round);
  const rows = [
    ...lens.shares.map((share) => ({
      ...share,
      name: worded(texts, siteName(project, share.handle)),
      kind: 'own',
    })),
    {
      name: words.virtualHandles,
      weight: lens.virtual_weight,
      passed_on: 0,
      distance: null,
      kind: 'all-virtual',
    },
  ];
  const keyAt = (rows.length + 1) * ROW;
  const radius = falloff?.site.support_radius ?? null;
  const content = svg`
    <text class="strong">${words.weightsAt(x, y)}</text>
    ${rows.map((row, at) => weightRow(row, (at + 1) * ROW))}
    <g transform="translate(0 ${keyAt})">
      ${figureKey([
        ['own', words.ownWeight],
        ['passed', words.passedOn],
      ])}
    </g>
    ${
      falloff && radius !== null
        ? svg`<g transform="translate(0 ${keyAt + ROW + GAP})">
            <text class="strong">${falloffTitle(falloff, project, texts)}</text>
            <g transform="translate(0 12)">${falloffChart(falloff, radius, words)}</g>
          </g>`
        : nothing
    }`;
  return { content, width, height: keyAt + ROW + GAP + (radius === null ? 0 : FALLOFF_HEIGHT) };
}

interface Row {
  readonly name: string;
  readonly weight: number;
  readonly passed_on: number;
  readonly distance: number | null;
  readonly kind: string;
}

function weightRow({ name, weight, passed_on, distance, kind }: Row, at: number): SVGTemplateResult {
  const { bar, barWidth, number, width } = COLUMN;
  const own = weight * barWidth;
  return svg`<g transform="translate(0 ${at})">
    <text>${name}</text>
    <rect class="track" x=${bar} y="-10" width=${barWidth} height="11" rx="3"/>
    <rect class="weight ${kind}" x=${bar} y="-10" width=${own.toFixed(1)} height="11"/>
    <rect class="weight passed" x=${(bar + own).toFixed(1)} y="-10" width=${(passed_on * barWidth).toFixed(1)} height="11"/>
    <text x=${number}>${percent(weight)}</text>
    ${distance === null ? nothing : svg`<text class="tick" text-anchor="end" x=${width}>${pixels(distance)}</text>`}
  </g>`;
}
