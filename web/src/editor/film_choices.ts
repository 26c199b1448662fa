/** How a person exports films: kept for the next one, and stored with the work. */
import { clipNamed, clipsOf } from '../document/clips';
import type { Clip, Project } from '../document/project';

/** `frames`: a zip of PNG files. `sheet`: a zip of a sprite sheet and its JSON. */
export type FilmFormat = 'webm' | 'mp4' | 'gif' | 'apng' | 'webp' | 'frames' | 'sheet';

/** Beginning and end, in seconds from the beginning of the clip. */
export type Range = readonly [from: number, to: number];

export interface FilmChoices {
  /** The name of the clip; null for that of the timeline, or else the first. */
  readonly clip: string | null;
  /** Null for the best one that the browser can encode. */
  readonly format: FilmFormat | null;
  /** Of WebM and MP4, 1 to 100. */
  readonly quality: number;
  /** Pixels of the film per 100 pixels of the picture. */
  readonly percent: number;
  readonly area: FilmArea;
  /** Frames a second. */
  readonly rate: number;
  /** Null for the whole clip. */
  readonly range: Range | null;
  readonly transparent: boolean;
  /** The colour behind the picture, as `#rrggbb`, unless it is transparent. */
  readonly background: string;
  /** The colour that soft edges of a transparent GIF are mixed with. */
  readonly matte: string;
}

/** The rectangle of the original, also grown to hold all frames. */
export type FilmArea = 'picture' | 'grown';

export const DEFAULT_FILM: FilmChoices = {
  clip: null,
  format: null,
  quality: 75,
  percent: 100,
  area: 'picture',
  rate: 30,
  range: null,
  transparent: true,
  background: '#ffffff',
  matte: '#ffffff',
};

/** Frames a second. Above the most of a GIF, viewers slow it down. */
export const FILM_RATES = { least: 1, most: 120, mostOfGif: 50 } as const;

export const FILM_FORMATS = {
  webm: { name: 'WebM', extension: 'webm', suffix: '' },
  mp4: { name: 'MP4', extension: 'mp4', suffix: '' },
  gif: { name: 'GIF', extension: 'gif', suffix: '' },
  apng: { name: 'APNG', extension: 'png', suffix: '' },
  webp: { name: 'WebP', extension: 'webp', suffix: '' },
  frames: { name: 'PNGs', extension: 'zip', suffix: '-frames' },
  sheet: { name: 'Sheet', extension: 'zip', suffix: '-sheet' },
} as const satisfies Record<FilmFormat, object>;

/** Encoded by the browser, with a quality. */
export type VideoFormat = 'webm' | 'mp4';
export const isVideo = (format: FilmFormat): format is VideoFormat => format === 'webm' || format === 'mp4';

/** Bits of a pixel at a quality of 0 and of 100. In between they grow by equal factors. */
const VIDEO_BITS = { least: 0.01, most: 0.3 } as const;

/** Bits of a video for each of its pixels. */
export const videoBits = (quality: number): number =>
  VIDEO_BITS.least * (VIDEO_BITS.most / VIDEO_BITS.least) ** (quality / 100);

/** The codec of a browser for a video format, and the pixels of the film. */
export interface VideoCodec {
  readonly codec: 'vp9' | 'vp8' | 'avc' | 'av1';
  readonly width: number;
  readonly height: number;
}

/** By format; null where the browser has no codec. */
export type VideoCodecs = Readonly<Record<VideoFormat, VideoCodec | null>>;

/** The clip that is exported; null without clips. */
export const filmedClip = (project: Project, { clip }: FilmChoices, open: string | null): Clip | null =>
  clipNamed(project, clip ?? '') ?? clipNamed(project, open ?? '') ?? clipsOf(project)[0] ?? null;

/** The chosen format, or the best one, as far as the browser can encode it. Null before that is known. */
export function filmFormat({ format }: FilmChoices, codecs: VideoCodecs | null): FilmFormat | null {
  if (format && !isVideo(format)) return format;
  if (!codecs) return null;
  const wanted = format ?? 'webm';
  return codecs[wanted] ? wanted : 'gif';
}

/** The chosen part within a clip; null for all of it. */
export function filmedRange({ duration }: Clip, range: Range | null): Range | null {
  if (!range) return null;
  const [from, to] = [Math.max(0, range[0]), Math.min(duration, range[1])];
  return from < to && (from > 0 || to < duration) ? [from, to] : null;
}

/** Frames a second in a format. */
export const filmRate = (format: FilmFormat, rate: number): number =>
  format === 'gif' ? Math.min(rate, FILM_RATES.mostOfGif) : rate;

/** Whether the film is transparent where the picture is. */
export const isTransparent = (format: FilmFormat, { transparent }: FilmChoices): boolean =>
  transparent && format !== 'mp4';
