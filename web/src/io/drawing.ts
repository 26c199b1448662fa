/**
 * SVG drawings as pixels. The page renders them as an image: there, no script runs and no other file is loaded.
 *
 * Small drawings are enlarged, so that handles find room. A page cannot interrupt the rendering, so a worker draws or
 * rejects drawings that take long.
 */
import { say } from '../texts/wording';
import { xmlText } from './formats/xml_text';
import { pictureError } from './picture_error';
import { readBytes, readSignature } from './read';

/** The longer side of small drawings, in pixels. */
const LEAST_SIDE = 1024;
/** The longer side of the largest drawings. */
const MOST_SIDE = 4096;
/** Larger files are refused, as in Rust. */
const MOST_BYTES = 64 << 20;

export const DRAWING_TYPE = 'image/svg+xml';

/** A drawing in UTF-8, and a picture of it. */
export interface Drawn {
  readonly file: Blob;
  readonly pixels: Blob;
  /** Whether texts of the drawing are missing in the picture. */
  readonly lacksTexts: boolean;
}

/** Draws a drawing as a PNG outside the page, without texts; null if a browser draws it quickly. */
export type DrawApart = (
  svg: string,
  width: number,
  height: number,
) => Promise<{ readonly png: Uint8Array<ArrayBuffer> | null; readonly lacksTexts: boolean }>;

/**
 * Parts of drawings that may take a browser long: filters, pictures and copies. Entities, references to characters, and
 * escapes of CSS can hide them. Illustrator declares entities for its namespaces.
 */
const MAY_BE_SLOW =
  /filter|<!ENTITY\s+\S+\s+(?!["']https?:)|&#|\\|<(?:[\w.-]+:)?(?:image|marker|mask|pattern|use)\b/i;

/**
 * Draws an SVG file as a picture. Returns null for a compressed file that is not SVG.
 *
 * @throws C2WarpError if the drawing cannot be shown; ReadError if the bytes cannot be read.
 */
export async function drawnPicture(given: Blob, drawApart: DrawApart): Promise<Drawn | null> {
  const file = await decompressed(given);
  if (!file) return null;
  const read = xmlText(await readBytes(file));
  if (!('text' in read))
    throw pictureError('picture', say('errors.picture.drawingEncoding', read.unreadableAs));
  const { sized, width, height } = sizedDrawing(read.text);
  const isQuick = !MAY_BE_SLOW.test(sized);
  const apart = isQuick ? { png: null, lacksTexts: false } : await drawApart(sized, width, height);
  return {
    file: new Blob([read.text], { type: DRAWING_TYPE }),
    pixels: apart.png
      ? new Blob([apart.png])
      : await rendered(new Blob([sized], { type: DRAWING_TYPE }), width, height),
    lacksTexts: apart.lacksTexts,
  };
}

/** A drawing, decompressed if necessary; null for other compressed files. @throws C2WarpError if it is too large. */
async function decompressed(file: Blob): Promise<Blob | null> {
  const tooLarge = () => pictureError('picture', say('errors.picture.drawingTooLarge'));
  if (file.size > MOST_BYTES) throw tooLarge();
  if ((await readSignature(file)).name !== 'compressed') return file;
  if (typeof DecompressionStream === 'undefined') return null;
  let left = MOST_BYTES;
  const bounded = new TransformStream<Uint8Array, Uint8Array>({
    transform(bytes, controller) {
      left -= bytes.length;
      if (left < 0) controller.terminate();
      else controller.enqueue(bytes);
    },
  });
  const stream = file.stream().pipeThrough(new DecompressionStream('gzip')).pipeThrough(bounded);
  const whole = await new Response(stream).blob().catch(() => null);
  if (!whole || (await readSignature(whole)).kind !== 'drawing') return null;
  if (left < 0) throw tooLarge();
  return whole;
}

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

async function rendered(file: Blob, width: number, height: number): Promise<Blob> {
  const image = new Image();
  image.src = URL.createObjectURL(file);
  try {
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    canvas.getContext('2d')?.drawImage(image, 0, 0, width, height);
    const png = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
    if (!png) throw new Error('not enough memory for the canvas');
    return png;
  } catch (cause) {
    throw pictureError('picture', say('errors.picture.drawingDamaged'), { cause });
  } finally {
    URL.revokeObjectURL(image.src);
  }
}
