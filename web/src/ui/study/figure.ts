/** Shared parts of the figures: scales, axes and paths. */
import { type SVGTemplateResult, svg } from 'lit-html';
import type { Vec } from '../../geometry/vec';

/** A rectangle of a figure that a range of numbers is drawn in. */
export interface Plot {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  readonly x: readonly [from: number, to: number];
  readonly y: readonly [from: number, to: number];
}

const along = (value: number, [from, to]: readonly [number, number], start: number, end: number): number =>
  start + ((end - start) * (value - from)) / (to - from || 1);

export const plotX = (plot: Plot, x: number): number => along(x, plot.x, plot.left, plot.right);
export const plotY = (plot: Plot, y: number): number => along(y, plot.y, plot.bottom, plot.top);

/** The number that a place of the figure stands for. */
export const numberAtX = (plot: Plot, place: number): number =>
  along(place, [plot.left, plot.right], plot.x[0], plot.x[1]);

/** A path through places, with one digit behind the point. */
export const pathOf = (places: readonly Vec[], closed = false): string =>
  places.length === 0
    ? ''
    : `M${places.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}${closed ? 'Z' : ''}`;

/** The least of many numbers: `Math.min` takes fewer arguments. */
export const least = (values: readonly number[]): number =>
  values.reduce((a, b) => Math.min(a, b), Number.POSITIVE_INFINITY);
/** The greatest of many numbers. */
export const most = (values: readonly number[]): number =>
  values.reduce((a, b) => Math.max(a, b), Number.NEGATIVE_INFINITY);

/** A drawing with its size. */
export interface Drawn {
  readonly content: SVGTemplateResult;
  readonly width: number;
  readonly height: number;
}

/** Characters of East Asian scripts take the room of two. */
const WIDE = /[\u3000-\u9fff\uff00-\uffef]/g;
/** The width of a text in Latin characters, about. */
export const widthOf = (text: string): number => text.length + (text.match(WIDE)?.length ?? 0);

/** A text in lines as wide as `length` Latin characters at most, broken between words. */
export function linesOf(text: string, length: number): readonly string[] {
  const lines: string[] = [];
  for (const { segment } of new Intl.Segmenter(undefined, { granularity: 'word' }).segment(text)) {
    const last = lines.at(-1);
    // Marks stay with the word before them.
    const fits =
      last !== undefined && (widthOf(last + segment) <= length || /^[^\p{L}\p{N}(]/u.test(segment));
    if (fits) lines[lines.length - 1] = last + segment;
    else lines.push(segment);
  }
  return lines.map((line) => line.trim());
}

/** A number of pixels. */
export const pixels = (length: number): string => `${Math.round(length).toLocaleString('en')} px`;

/** The axes of a plot, with round numbers along both. */
export const axes = (
  plot: Plot,
  xTicks: readonly number[],
  yTicks: readonly number[],
): SVGTemplateResult => svg`
  <path class="axis" d="M${plot.left} ${plot.top}V${plot.bottom}H${plot.right}"/>
  ${xTicks.map((x) => svg`<text class="tick" text-anchor="middle" x=${plotX(plot, x)} y=${plot.bottom + 16}>${x.toLocaleString('en')}</text>`)}
  ${yTicks.map((y) => svg`<text class="tick" text-anchor="end" x=${plot.left - 6} y=${plotY(plot, y) + 4}>${y.toLocaleString('en')}</text>`)}`;
