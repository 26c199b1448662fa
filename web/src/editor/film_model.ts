/** The film page of the export panel as people see it. */

import { clipsOf } from '../document/clips';
import type { Clip } from '../document/project';
import type { Size } from '../geometry/camera';
import type { Wording } from '../texts/wording';
import {
  FILM_FORMATS,
  type FilmChoices,
  type FilmFormat,
  filmedClip,
  filmedRange,
  filmFormat,
  filmRate,
  isTransparent,
  isVideo,
  type Range,
  type VideoCodec,
  videoBits,
} from './film_choices';
import { type EditorState, filedProject } from './state';

export interface FilmModel {
  /** The names of all clips. */
  readonly clips: readonly string[];
  /** Null without clips. */
  readonly clip: Clip | null;
  readonly choices: FilmChoices;
  /** Null until the browser's codecs are known. */
  readonly format: FilmFormat | null;
  /** The formats that the browser lacks. */
  readonly lacking: readonly FilmFormat[];
  /** Of the chosen video format. */
  readonly codec: VideoCodec | null;
  readonly transparent: boolean;
  /** Null for the whole clip. */
  readonly range: Range | null;
  /** In pixels; of a grown area, about. */
  readonly size: Size | null;
  readonly frames: number;
  /** Why there can be no such film; null if there can. */
  readonly refusal: Wording | null;
  readonly estimate: { readonly bytes: number; readonly seconds: number };
}

export function filmModel(state: EditorState): FilmModel {
  const { film: choices, codecs } = state.exporting;
  const project = filedProject(state);
  const clip = filmedClip(project, choices, state.timeline.clip);
  const format = filmFormat(choices, codecs);
  const range = clip && filmedRange(clip, choices.range);
  const counted = clip ? frameCount(state, clip) : { frames: 0, refusal: null };
  const size = filmSize(state);
  return {
    clips: clipsOf(project).map(({ name }) => name),
    clip,
    choices,
    format,
    lacking: codecs ? formats().filter((one) => isVideo(one) && !codecs[one]) : [],
    codec: format && isVideo(format) ? (codecs?.[format] ?? null) : null,
    transparent: format !== null && isTransparent(format, choices),
    range,
    size,
    ...counted,
    estimate: estimated(format ?? 'gif', choices, size, counted.frames),
  };
}

const formats = (): readonly FilmFormat[] => Object.keys(FILM_FORMATS) as FilmFormat[];

function frameCount(
  state: EditorState,
  clip: Clip,
): { readonly frames: number; readonly refusal: Wording | null } {
  const { film, codecs } = state.exporting;
  const rate = filmRate(filmFormat(film, codecs) ?? 'gif', film.rate);
  const deformation = state.solution.shown?.deformation;
  if (!deformation) return { frames: 0, refusal: null };
  return deformation.filmFrames(filedProject(state), clip, rate, filmedRange(clip, film.range));
}

/** The pixels of a film by the present choices; null without a picture or a clip. */
export function filmSize(state: EditorState): Size | null {
  const { film } = state.exporting;
  const { picture } = state;
  const project = filedProject(state);
  const clip = filmedClip(project, film, state.timeline.clip);
  if (!picture || !clip) return null;
  const posed =
    film.area === 'grown'
      ? state.solution.shown?.deformation.filmBounds(project, clip, filmedRange(clip, film.range))
      : null;
  const [left, top] = posed?.min ?? [0, 0];
  const [right, bottom] = posed?.max ?? [picture.width, picture.height];
  const scaled = (side: number) => Math.max(1, Math.round((side * film.percent) / 100));
  return {
    width: scaled(Math.max(right, picture.width) - Math.min(left, 0)),
    height: scaled(Math.max(bottom, picture.height) - Math.min(top, 0)),
  };
}

/** Bytes and seconds for a million pixels, roughly: measured with a sample on two cores in November 2026. */
const COSTS: Readonly<Record<FilmFormat, { readonly bytes: number; readonly seconds: number }>> = {
  webm: { bytes: 0, seconds: 0.35 },
  mp4: { bytes: 0, seconds: 0.3 },
  gif: { bytes: 350_000, seconds: 0.3 },
  apng: { bytes: 850_000, seconds: 0.35 },
  webp: { bytes: 700_000, seconds: 0.3 },
  frames: { bytes: 900_000, seconds: 0.35 },
  sheet: { bytes: 850_000, seconds: 0.4 },
};

function estimated(format: FilmFormat, choices: FilmChoices, size: Size | null, frames: number) {
  const millions = size ? (size.width * size.height * frames) / 1e6 : 0;
  const { bytes, seconds } = COSTS[format];
  const perMillion = isVideo(format) ? (videoBits(choices.quality) * 1e6) / 8 : bytes;
  return { bytes: millions * perMillion, seconds: millions * seconds };
}
