/** Texts about films. */
import { FILM_RATES, type FilmFormat, type VideoCodec } from './film_choices';

export const NO_CLIP_TO_EXPORT = 'There is no clip yet: a film shows one.';

export const FORMAT_NOTES: Readonly<Record<FilmFormat, string>> = {
  webm: 'Small, with soft transparency. For web pages.',
  mp4: 'Small, without transparency. Plays nearly everywhere.',
  gif: 'Plays everywhere. 255 colours, hard edges.',
  apng: 'Every pixel as it is, with soft transparency.',
  webp: 'Every pixel as it is, smaller than an APNG.',
  frames: 'A zip of one PNG for each frame.',
  sheet: 'A zip of all frames in one PNG, with a JSON file for game engines.',
};

const CODEC_NAMES: Readonly<Record<VideoCodec['codec'], string>> = {
  vp9: 'VP9',
  vp8: 'VP8',
  avc: 'H.264',
  av1: 'AV1',
};

/** @param even the pixels of the film, if it gets a column or a row more. */
export function codecText({ codec, width, height }: VideoCodec, even: boolean): string {
  const padded = even ? ` It has even sides: ${width} × ${height} px.` : '';
  return `By ${CODEC_NAMES[codec]}.${padded}`;
}

export const NO_CODEC = 'this browser does not encode it.';

export const GIF_RATE = `A GIF gets ${FILM_RATES.mostOfGif} frames a second, the most that viewers play.`;

const PREFIXES = [
  [1e9, 'GB'],
  [1e6, 'MB'],
  [1e3, 'kB'],
] as const;

/** A rough size, with one digit that counts. */
export function roughSize(bytes: number): string {
  const [unit, name] = PREFIXES.find(([least]) => bytes >= least) ?? [1e3, 'kB'];
  const value = bytes / unit;
  return `${value >= 10 ? Math.round(value / 5) * 5 : Math.max(1, Math.round(value))} ${name}`;
}

/** A rough time, as people say it. */
export function roughTime(seconds: number): string {
  if (seconds < 5) return 'a few seconds';
  if (seconds < 57.5) return `${Math.round(seconds / 5) * 5} s`;
  return `${Math.round(seconds / 60)} min`;
}

export const timeLeftText = (seconds: number): string =>
  seconds < 5 ? 'a few seconds left' : `about ${roughTime(seconds)} left`;

export const framesText = (frames: number): string =>
  `${frames.toLocaleString('en')} ${frames === 1 ? 'frame' : 'frames'}`;
