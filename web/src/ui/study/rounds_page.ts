/** Algorithm 1 round by round (section IV-A), with the score curve of figure 3. */

import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { Dispatch } from '../../editor/events';
import { type RoundModel, roundModel } from '../../editor/rounds_model';
import type { EditorModel } from '../../editor/view_model';
import { ticks } from '../../geometry/ticks';
import type { Vec } from '../../geometry/vec';
import type { Texts } from '../../texts/texts';
import { icon } from '../icons';
import { axes, type Drawn, least, most, type Plot, pathOf, plotX, plotY } from './figure';
import { mapFrame, shape, siteDots } from './map_figure';
import { saveButton } from './save_button';

const WIDTH = 294;
const MAP_HEIGHT = 220;
export const CURVE_HEIGHT = 150;

export function roundsPage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const shown = roundModel(model.study);
  const { rounds: texts } = model.texts;
  if (!shown) return html`<p class="faint">${texts.none}</p>`;
  const { playing } = model.study.replay;
  const { index, study } = shown;
  const words = model.worded(shown.words);
  const last = study.rounds.length - 1;
  const go = (round: number) => dispatch({ type: 'round-shown', round });
  const map = roundMap(shown, WIDTH, MAP_HEIGHT);
  const step = (label: string, symbol: TemplateResult, to: number) => html`<button
    type="button"
    class="button"
    part="button"
    data-tip=${label}
    aria-label=${label}
    ?disabled=${to < 0 || to > last}
    @click=${() => go(to)}
  >
    ${symbol}
  </button>`;
  return html`
    <h3>${texts.title}</h3>
    <svg class="figure map" viewBox="0 0 ${map.width} ${map.height}" role="img" aria-label=${words}>${map.content}</svg>
    <p class="round-words" role="status">${playing ? nothing : words}</p>
    <div class="player">
      <button
        type="button"
        class="button"
        part="button"
        data-tip=${playing ? texts.pause : texts.play}
        aria-label=${playing ? texts.pause : texts.play}
        ?disabled=${last < 1}
        @click=${() => dispatch({ type: 'replay-switched', on: !playing })}
      >
        ${icon(playing ? 'pause' : 'play')}
      </button>
      ${step(texts.previous, icon('back'), index - 1)} ${step(texts.next, icon('next'), index + 1)}
      <input
        type="range"
        class="slider"
        aria-label=${texts.round}
        aria-valuetext=${texts.roundOf(index + 1, last + 1)}
        min="0"
        max=${last}
        .value=${live(String(index))}
        @input=${(event: Event) => {
          event.stopPropagation();
          go(Number((event.target as HTMLInputElement).value));
        }}
        @change=${(event: Event) => event.stopPropagation()}
      />
      <output class="number">${index + 1} / ${last + 1}</output>
    </div>
    <svg class="figure" viewBox="0 0 ${WIDTH} ${CURVE_HEIGHT}" role="img" aria-label=${curveLabel(shown, texts)}>
      ${scoreCurve(shown, WIDTH, texts)}
    </svg>
    <p class="faint">
      ${texts.note}
    </p>
    ${saveButton('rounds', model.texts, dispatch)}`;
}

const curveLabel = ({ round, study }: RoundModel, { curve }: Texts['rounds']): string =>
  curve(round.score.toFixed(2), study.allowed_score.toFixed(2));

/** The shape with the sites before the round, and the points where it inserts. */
export function roundMap({ study, sites, round }: RoundModel, width: number, height: number): Drawn {
  const frame = mapFrame(study.outline.flat(), width, height);
  const { place, scale } = frame;
  const content = svg`${shape(study.outline, frame)}
    ${round.points.map(({ owner, distance, limit, path }) => {
      const site = sites[owner];
      if (!site) return nothing;
      const [x, y] = place(site.rest);
      return svg`${round.score > study.allowed_score ? svg`<circle class="allowed" cx=${x} cy=${y} r=${(scale * Math.min(limit, 4 * distance)).toFixed(1)}/>` : nothing}
        <path class="radius cell-radius on-map" d=${pathOf(path.map(place))}/>`;
    })}
    ${siteDots(
      sites.map(({ rest }) => place(rest)),
      sites.map(({ handle }) => handle),
    )}
    ${round.points.map(({ at }) => {
      const [x, y] = place(at);
      return svg`<circle class="entering" cx=${x} cy=${y} r="6"/>`;
    })}`;
  return { content, width, height: frame.height };
}

/** The scores of all rounds, the line that ends the algorithm, and the round on show. */
export function scoreCurve(
  { study, index, round }: RoundModel,
  width: number,
  texts: Texts['rounds'],
): SVGTemplateResult {
  const scores = study.rounds.map(({ score }) => Math.max(score, -1));
  const top = Math.max(most(scores), 0.2);
  const bottom = Math.min(least(scores), study.allowed_score) - 0.08;
  const plot: Plot = {
    left: 36,
    right: width - 14,
    top: 8,
    bottom: CURVE_HEIGHT - 36,
    x: [1, Math.max(study.rounds.length, 2)],
    y: [bottom, top],
  };
  const line = scores.map((score, at): Vec => [plotX(plot, at + 1), plotY(plot, score)]);
  const allowed = plotY(plot, study.allowed_score);
  const [x, y] = [plotX(plot, index + 1), plotY(plot, Math.max(round.score, -1))];
  const whole = ticks(plot.x, 5).filter((tick) => Number.isInteger(tick));
  return svg`${axes(plot, whole, ticks(plot.y, 4))}
    <text class="tick" text-anchor="end" x=${plot.right} y=${CURVE_HEIGHT - 4}>${texts.roundAxis}</text>
    <path class="limit" d="M${plot.left} ${allowed}H${plot.right}"/>
    <text class="tick" text-anchor="end" x=${plot.right} y=${allowed - 5}>${texts.allowed}</text>
    <path class="curve" d=${pathOf(line)}/>
    <path class="at" d="M${x} ${plot.bottom}V${y}"/><circle class="at-dot" cx=${x} cy=${y} r="4.5"/>`;
}
