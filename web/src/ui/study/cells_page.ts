/** The cells with their radii r_d and r_h (figure 2), and the times of the stages. */

import { html, nothing, svg, type TemplateResult } from 'lit-html';
import type { Study } from '../../document/generated/study';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';
import { type Drawn, pathOf } from './figure';
import { mapFrame, shape, siteDots } from './map_figure';
import { saveButton } from './save_button';
import { withSymbols } from './symbols';

const WIDTH = 294;
const HEIGHT = 380;

const STAGES = ['domain', 'sampling', 'regions', 'weights', 'pose'] as const;

export function cellsPage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const study = model.study.explained?.study;
  const { cells: words } = model.texts;
  if (!study || study.sites.length === 0) return html`<p class="faint">${words.none}</p>`;
  const map = cellsMap(study, model, WIDTH, HEIGHT);
  const virtual = study.sites.filter(({ handle }) => handle === -1).length;
  return html`
    <h3>${words.counts(study.sites.length - virtual, virtual)}</h3>
    <svg class="figure map" viewBox="0 0 ${map.width} ${map.height}" role="img" aria-label=${words.label}>
      ${map.content}
    </svg>
    <p class="faint key">
      <span class="meaning"><span class="swatch of-farthest"></span>${withSymbols(words.farthest)}</span>
      <span class="meaning"><span class="swatch of-nearest"></span>${withSymbols(words.nearest)}</span>
    </p>
    <p class="faint">${withSymbols(words.note)}</p>
    ${saveButton('cells', model.texts, dispatch)}
    <h3 class="times-title">${words.times}</h3>
    <dl class="times">
      ${STAGES.map(
        (stage) =>
          html`<div><dt>${words.stages[stage]}</dt><dd>${milliseconds(model.solved?.times[stage] ?? 0)}</dd></div>`,
      )}
    </dl>`;
}

const milliseconds = (ms: number): string => `${ms >= 10 ? Math.round(ms) : ms.toFixed(1)} ms`;

/** The posed shape with borders, radii and sites. */
export function cellsMap(study: Study, model: EditorModel, width: number, height: number): Drawn {
  const outline = model.posedLines(study.outline, Number.POSITIVE_INFINITY);
  const frame = mapFrame(outline.flat(), width, height);
  const { place } = frame;
  const line = (lines: readonly (readonly (readonly [number, number])[])[]) =>
    model
      .posedLines(
        lines.filter(({ length }) => length > 1),
        Number.POSITIVE_INFINITY,
      )
      .map((path) => pathOf(path.map(place)))
      .join('');
  const rests = model.posedLines(
    study.sites.map(({ rest }) => [rest]),
    1,
  );
  const borders = model.borders;
  const content = svg`${shape(outline, frame)}
    ${borders ? svg`<path class="border" d=${pieces(borders, place)}/>` : nothing}
    <path class="radius separation on-map" d=${line(study.sites.map(({ to_nearest }) => to_nearest))}/>
    <path class="radius cell-radius on-map" d=${line(study.sites.map(({ to_farthest }) => to_farthest))}/>
    ${siteDots(
      rests.flat().map(place),
      study.sites.map(({ handle }) => handle),
    )}`;
  return { content, width, height: frame.height };
}

function pieces(
  borders: Float32Array,
  place: (at: readonly [number, number]) => readonly [number, number],
): string {
  let path = '';
  for (let at = 0; at + 3 < borders.length; at += 4) {
    const [a = 0, b = 0, c = 0, d = 0] = borders.subarray(at, at + 4);
    path += pathOf([place([a, b]), place([c, d])]);
  }
  return path;
}
