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
  type VideoCodec,
} from '../../editor/film_choices';
import type { FilmModel } from '../../editor/film_model';
import { roughSize, roughTime } from '../../editor/film_words';
import { secondsText } from '../../editor/seconds';
import type { EditorModel } from '../../editor/view_model';
import { shownName } from '../../texts/shown_name';
import type { Texts } from '../../texts/texts';
import { closePopover } from '../close_popover';
import { type FieldLook, numberField } from '../number_field';
import {
  changed,
  choice,
  colourOption,
  exportRow,
  keptValue,
  qualityOption,
  sizeLook,
  sizeText,
} from './controls';

/** Formats without a name of their own have one in each language. */
const formatNames = ({ film }: Texts): Readonly<Record<FilmFormat, string>> => ({
  webm: FILM_FORMATS.webm.name,
  mp4: FILM_FORMATS.mp4.name,
  gif: FILM_FORMATS.gif.name,
  apng: FILM_FORMATS.apng.name,
  webp: FILM_FORMATS.webp.name,
  frames: film.frames,
  sheet: film.sheet,
});

const CODEC_NAMES: Readonly<Record<VideoCodec['codec'], string>> = {
  vp9: 'VP9',
  vp8: 'VP8',
  avc: 'H.264',
  av1: 'AV1',
};

const COMMON = { digitKeys: true, changesNothing: true } as const;
const rateLook = ({ film }: Texts): FieldLook => ({
  name: 'rate',
  label: film.rate,
  unit: 'fps',
  tip: film.rateTip,
  step: 1,
  digits: 2,
  least: FILM_RATES.least,
  most: FILM_RATES.most,
  ...COMMON,
});

type Choose = (choice: Partial<FilmChoices>) => void;

export function filmPage(film: FilmModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { texts } = model;
  if (!film.clip) return withoutClip(texts, dispatch);
  const choose: Choose = (choice) => dispatch({ type: 'film-choice-made', choice });
  const { choices, format } = film;
  const areas = { picture: texts.exporting.original, grown: texts.film.allFrames };
  const formats = formatNames(texts);
  return html`${clipOption(film, texts, choose)}
    <div class="formats">
      ${choice(texts.exporting.format, formats, format, (format) => choose({ format }), film.lacking)}
    </div>
    <p class="faint">${formatNote(film, texts)}</p>
    ${format && isVideo(format) ? qualityOption(choices.quality, texts, (quality) => choose({ quality })) : nothing}
    <div class="film-fields">
      ${numberField(sizeLook(texts), [choices.percent], (change) => choose({ percent: changed(choices.percent, change) }), model, dispatch)}
      ${numberField(rateLook(texts), [choices.rate], (change) => choose({ rate: changed(choices.rate, change) }), model, dispatch)}
    </div>
    ${choice(texts.exporting.area, areas, choices.area, (area) => choose({ area }))} ${part(film, choose, model, dispatch)} ${background(film, texts, choose)}
    ${film.refusal ? html`<p class="film-refusal" role="status">${model.worded(film.refusal)}</p>` : nothing}
    ${exportRow(summary(film, model), texts.exporting.export(format ? formats[format] : ''), !format || film.refusal !== null, model, dispatch)}`;
}

const withoutClip = (
  { film }: Texts,
  dispatch: Dispatch,
): TemplateResult => html`<p class="faint">${film.noClip}</p>
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
      ${film.openTimeline}
    </button>
  </div>`;

const clipOption = (
  { clips, clip }: FilmModel,
  { film }: Texts,
  choose: Choose,
): TemplateResult | typeof nothing =>
  clips.length < 2
    ? nothing
    : html`<label class="option">
        <span>${film.clip}</span>
        <select
          class="choice"
          name="clip"
          aria-label=${film.clip}
          @change=${(event: Event) => choose({ clip: keptValue(event) })}
          @input=${keptValue}
        >
          ${clips.map((name) => html`<option .value=${name} ?selected=${name === clip?.name}>${shownName(name)}</option>`)}
        </select>
      </label>`;

/** The use of the format, its codec, and the reason against others. */
function formatNote({ format, codec, size, choices, lacking, clip }: FilmModel, texts: Texts): string {
  if (!format || !clip) return '';
  const { film, names } = texts;
  const isLarger =
    codec !== null && size !== null && (codec.width !== size.width || codec.height !== size.height);
  const isEven = choices.area === 'picture' && isLarger;
  const lackingNames = lacking.map((one) => formatNames(texts)[one]);
  return names.sentences([
    film.formatNotes[format],
    ...(codec ? [codecText(codec, isEven, texts)] : []),
    ...(filmRate(format, choices.rate) < choices.rate ? [film.gifRate(FILM_RATES.mostOfGif)] : []),
    ...(lacking.length > 0 ? [film.noCodec(lackingNames)] : []),
  ]);
}

/** @param isEven the film gets a column or a row more. */
const codecText = ({ codec, width, height }: VideoCodec, isEven: boolean, { film }: Texts): string =>
  isEven ? film.codecWithEvenSides(CODEC_NAMES[codec], width, height) : film.codec(CODEC_NAMES[codec]);

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
  const { film: words } = model.texts;
  const parts = { whole: words.wholeClip, part: words.aPart };
  return html`${choice(words.part, parts, chosen, (kind) => choose({ range: kind === 'part' ? [0, duration] : null }))}
    ${
      choices.range
        ? html`<div class="film-fields">
            ${field('from', words.from, from, (value) => [value, to])}
            ${field('to', words.to, to, (value) => [from, value])}
          </div>`
        : nothing
    }`;
}

function background(
  { format, transparent, choices }: FilmModel,
  { film, exporting }: Texts,
  choose: Choose,
): TemplateResult {
  const colour = colourOption(exporting.background, 'background', choices.background, (background) =>
    choose({ background }),
  );
  if (format === 'mp4') return colour;
  const chosen = transparent ? 'transparent' : 'colour';
  const matte = html`${colourOption(film.softEdgesOn, 'matte', choices.matte, (matte) => choose({ matte }))}`;
  const backgrounds = { transparent: film.transparent, colour: film.colour };
  return html`${choice(exporting.background, backgrounds, chosen, (kind) => choose({ transparent: kind === 'transparent' }))}
    ${transparent ? (format === 'gif' ? matte : nothing) : colour}`;
}

/** The frames and the pixels, and roughly the size of the file and the time that it takes. */
function summary(
  { clip, choices, size, frames, range, estimate }: FilmModel,
  { texts, worded }: EditorModel,
): TemplateResult {
  const [from, to] = range ?? [0, clip?.duration ?? 0];
  const { film, names } = texts;
  const lengths = names.parts([film.frameCount(frames), secondsText(to - from)]);
  const rough = film.estimate(roughSize(estimate.bytes), worded(roughTime(estimate.seconds)));
  return html`${sizeText(size, choices.area !== 'picture', texts)}<br />${lengths}<br />${rough}`;
}
