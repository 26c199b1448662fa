/** The export of a clip as a film. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import {
  FILM_FORMATS,
  FILM_RATES,
  type FilmChoices,
  type FilmFormat,
  filmRate,
  isVideo,
  type Range,
} from '../../editor/film_choices';
import type { FilmModel } from '../../editor/film_model';
import {
  codecText,
  FORMAT_NOTES,
  framesText,
  GIF_RATE,
  NO_CLIP_TO_EXPORT,
  NO_CODEC,
  roughSize,
  roughTime,
} from '../../editor/film_texts';
import { secondsText } from '../../editor/timeline_texts';
import type { EditorModel } from '../../editor/view_model';
import { closePopover } from '../close_popover';
import { type FieldLook, numberField } from '../number_field';
import {
  changed,
  choice,
  colourOption,
  exportRow,
  keptValue,
  qualityOption,
  SIZE,
  sizeText,
} from './controls';

const FORMATS = Object.fromEntries(
  Object.entries(FILM_FORMATS).map(([format, { name }]) => [format, name]),
) as Readonly<Record<FilmFormat, string>>;

const AREAS = { picture: 'Original', grown: 'All frames' } as const;
const PARTS = { whole: 'Whole clip', part: 'A part' } as const;
const BACKGROUNDS = { transparent: 'Transparent', colour: 'Colour' } as const;

const COMMON = { digitKeys: true, changesNothing: true } as const;
const RATE: FieldLook = {
  name: 'rate',
  label: 'Rate',
  unit: 'fps',
  tip: 'Frames a second',
  step: 1,
  digits: 2,
  least: FILM_RATES.least,
  most: FILM_RATES.most,
  ...COMMON,
};

type Choose = (choice: Partial<FilmChoices>) => void;

export function filmPage(film: FilmModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  if (!film.clip) return withoutClip(dispatch);
  const choose: Choose = (choice) => dispatch({ type: 'film-choice-made', choice });
  const { choices, format } = film;
  return html`${clipOption(film, choose)}
    <div class="formats">
      ${choice('Format', FORMATS, format, (format) => choose({ format }), film.lacking)}
    </div>
    <p class="faint">${formatNote(film)}</p>
    ${format && isVideo(format) ? qualityOption(choices.quality, (quality) => choose({ quality })) : nothing}
    <div class="film-fields">
      ${numberField(SIZE, [choices.percent], (change) => choose({ percent: changed(choices.percent, change) }), model, dispatch)}
      ${numberField(RATE, [choices.rate], (change) => choose({ rate: changed(choices.rate, change) }), model, dispatch)}
    </div>
    ${choice('Area', AREAS, choices.area, (area) => choose({ area }))} ${part(film, choose, model, dispatch)} ${background(film, choose)}
    ${film.refusal ? html`<p class="film-refusal" role="status">${film.refusal}</p>` : nothing}
    ${exportRow(told(film), format ? FILM_FORMATS[format].name : '', !format || film.refusal !== null, model, dispatch)}`;
}

const withoutClip = (dispatch: Dispatch): TemplateResult => html`<p class="faint">${NO_CLIP_TO_EXPORT}</p>
  <div class="row">
    <button
      type="button"
      class="primary"
      part="button"
      @click=${(event: Event) => {
        closePopover(event);
        dispatch({ type: 'timeline-opened', open: true });
      }}
    >
      Open the timeline
    </button>
  </div>`;

const clipOption = ({ clips, clip }: FilmModel, choose: Choose): TemplateResult | typeof nothing =>
  clips.length < 2
    ? nothing
    : html`<label class="option">
        <span>Clip</span>
        <select
          class="choice"
          name="clip"
          aria-label="Clip"
          @change=${(event: Event) => choose({ clip: keptValue(event) })}
          @input=${keptValue}
        >
          ${clips.map((name) => html`<option .value=${name} ?selected=${name === clip?.name}>${name}</option>`)}
        </select>
      </label>`;

/** The use of the format, its codec, and the reason against others. */
function formatNote({ format, codec, size, choices, lacking, clip }: FilmModel): string {
  if (!format || !clip) return '';
  const isLarger =
    codec !== null && size !== null && (codec.width !== size.width || codec.height !== size.height);
  const even = choices.area === 'picture' && isLarger;
  const names = lacking.map((one) => FILM_FORMATS[one].name).join(' and ');
  return [
    FORMAT_NOTES[format],
    ...(codec ? [codecText(codec, even)] : []),
    ...(filmRate(format, choices.rate) < choices.rate ? [GIF_RATE] : []),
    ...(names ? [`${names}: ${NO_CODEC}`] : []),
  ].join(' ');
}

/** The whole clip, or from one time to another. */
function part(
  { clip, choices, range }: FilmModel,
  choose: Choose,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const duration = clip?.duration ?? 0;
  const [from, to]: Range = range ?? [0, duration];
  const field = (name: string, label: string, value: number, set: (value: number) => Range): TemplateResult =>
    numberField(
      { name, label, unit: 's', step: 0.1, digits: 2, least: 0, most: duration, ...COMMON },
      [value],
      (change) => choose({ range: set(changed(value, change)) }),
      model,
      dispatch,
    );
  const chosen = choices.range ? 'part' : 'whole';
  return html`${choice('Part', PARTS, chosen, (kind) => choose({ range: kind === 'part' ? [0, duration] : null }))}
    ${
      choices.range
        ? html`<div class="film-fields">
            ${field('from', 'From', from, (value) => [value, to])}
            ${field('to', 'To', to, (value) => [from, value])}
          </div>`
        : nothing
    }`;
}

function background({ format, transparent, choices }: FilmModel, choose: Choose): TemplateResult {
  const colour = colourOption('Background', 'background', choices.background, (background) =>
    choose({ background }),
  );
  if (format === 'mp4') return colour;
  const chosen = transparent ? 'transparent' : 'colour';
  const matte = html`${colourOption('Soft edges on', 'matte', choices.matte, (matte) => choose({ matte }))}`;
  return html`${choice('Background', BACKGROUNDS, chosen, (kind) => choose({ transparent: kind === 'transparent' }))}
    ${transparent ? (format === 'gif' ? matte : nothing) : colour}`;
}

/** The frames and the pixels, and roughly the size of the file and the time that it takes. */
function told({ clip, choices, size, frames, range, estimate }: FilmModel): TemplateResult {
  const [from, to] = range ?? [0, clip?.duration ?? 0];
  return html`${sizeText(size, choices.area !== 'picture')}<br />${framesText(frames)}, ${secondsText(to - from)}<br />about
    ${roughSize(estimate.bytes)}, ${roughTime(estimate.seconds)}`;
}
