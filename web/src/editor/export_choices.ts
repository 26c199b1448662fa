/** How a person exports: kept for the next export, and stored with the work. */
import type { Area } from '../geometry/area';

export type ExportKind = 'picture' | 'film' | 'page' | 'engine' | 'maps';

export type ExportFormat = 'png' | 'jpeg' | 'webp' | 'svg';

/** Formats of pixels. */
export type PixelFormat = Exclude<ExportFormat, 'svg'>;

export interface ExportChoices {
  readonly format: ExportFormat;
  /** Of JPEG and WebP, 1 to 100. */
  readonly quality: number;
  /** Pixels of the export per 100 pixels of the picture. */
  readonly percent: number;
  readonly area: Area;
  /** The colour below translucent pixels of a JPEG, as `#rrggbb`. */
  readonly background: string;
}

export const DEFAULT_CHOICES: ExportChoices = {
  format: 'png',
  quality: 90,
  percent: 100,
  area: 'picture',
  background: '#ffffff',
};

/** The choices for a picture: only a drawing is exported as one, which has no size of its covered part. */
export function choicesFor(choices: ExportChoices, isDrawing: boolean): ExportChoices {
  if (choices.format !== 'svg') return choices;
  if (!isDrawing) return { ...choices, format: 'png' };
  return choices.area === 'covered' ? { ...choices, area: 'grown' } : choices;
}

export const QUALITIES = { least: 1, most: 100 } as const;
export const PERCENTS = { least: 1, most: 1000 } as const;

export const EXPORT_FORMATS = {
  png: { name: 'PNG', extension: 'png', type: 'image/png' },
  jpeg: { name: 'JPEG', extension: 'jpg', type: 'image/jpeg' },
  webp: { name: 'WebP', extension: 'webp', type: 'image/webp' },
  svg: { name: 'SVG', extension: 'svg', type: 'image/svg+xml' },
} as const satisfies Record<ExportFormat, object>;
