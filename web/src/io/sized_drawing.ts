/** Drawings with a size in whole pixels. Small ones are enlarged, so that handles find room. */
import { say } from '../texts/wording';
import { pictureError } from './picture_error';

/** The longer side of small drawings, in pixels. */
const LEAST_SIDE = 1024;
/** The longer side of the largest drawings. */
const MOST_SIDE = 4096;

interface SizedDrawing {
  readonly sized: string;
  readonly width: number;
  readonly height: number;
}

/** A drawing with a size in whole pixels. @throws C2WarpError if it has no size. */
export function sizedDrawing(text: string): SizedDrawing {
  const prologue =
    /^(?:\s|\ufeff|<\?[\s\S]*?\?>|<!--[\s\S]*?-->|<!DOCTYPE[^[>]*(?:\[[\s\S]*?\]\s*)?>)*/i.exec(text)?.[0] ??
    '';
  const [tag, name, attributes = ''] =
    /^<((?:[\w.-]{1,99}:)?svg)((?:\s+[\w:.-]+\s*=\s*(?:"[^"]*"|'[^']*'))*\s*)/.exec(
      text.slice(prologue.length),
    ) ?? [];
  if (tag === undefined) throw pictureError('picture', say('errors.picture.drawingDamaged'));
  const box =
    attributeOf(attributes, 'viewBox')
      ?.trim()
      .split(/[\s,]+/)
      .map(Number) ?? [];
  const [, , boxWidth = Number.NaN, boxHeight = Number.NaN] = box;
  const [ownWidth, ownHeight] = [lengthOf(attributes, 'width'), lengthOf(attributes, 'height')];
  const ratio = boxWidth / boxHeight;
  const across = ownWidth ?? (ownHeight === null ? boxWidth : ownHeight * ratio);
  const down = ownHeight ?? (ownWidth === null ? boxHeight : ownWidth / ratio);
  if (!(across > 0 && down > 0 && Number.isFinite(across * down)))
    throw pictureError('picture', say('errors.picture.drawingWithoutSize'));
  const side = Math.max(across, down);
  const scale = Math.min(Math.max(side, LEAST_SIDE), MOST_SIDE) / side;
  const [width, height] = [across, down].map((length) => Math.max(1, Math.round(length * scale))) as [
    number,
    number,
  ];
  const kept = attributes.replace(/\s(?:width|height)\s*=\s*(?:"[^"]*"|'[^']*')/g, '');
  const seen = box.length === 4 ? '' : ` viewBox="0 0 ${across} ${down}"`;
  const root = `<${name}${kept} width="${width}" height="${height}"${seen}`;
  return { sized: prologue + root + text.slice(prologue.length + tag.length), width, height };
}

function attributeOf(attributes: string, name: string): string | undefined {
  const [, , double, single] =
    new RegExp(`(^|\\s)${name}\\s*=\\s*(?:"([^"]*)"|'([^']*)')`).exec(attributes) ?? [];
  return double ?? single;
}

/** CSS pixels in each unit. */
const UNITS: Readonly<Record<string, number>> = {
  '': 1,
  px: 1,
  pt: 4 / 3,
  pc: 16,
  mm: 96 / 25.4,
  cm: 96 / 2.54,
  in: 96,
};

/** A length in pixels; null if it is relative or left out. */
function lengthOf(attributes: string, name: string): number | null {
  const [, number, unit = ''] =
    /^\s*([\d.e+-]+)\s*([a-z]*)\s*$/i.exec(attributeOf(attributes, name) ?? '') ?? [];
  const size = UNITS[unit.toLowerCase()];
  return number === undefined || size === undefined ? null : Number(number) * size;
}
