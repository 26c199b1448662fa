/** Reads a drawing by the WebAssembly module, in a worker or in the page. */
import type { C2WarpError } from '../error';
import { say, type Wording } from '../texts/wording';
import type { DrawingOrder, DrawingReplies, ReadPicture } from './drawing_messages';
import { signatureOf } from './formats/signature';
import { xmlText } from './formats/xml_text';
import init, { ReadDrawing } from './generated/drawing';
import { pictureError } from './picture_error';
import { readBytes } from './read';
import { sizedDrawing } from './sized_drawing';
import { unpackedDrawing } from './unpacked';

/** Larger files are refused, as in Rust. */
const MOST_BYTES = 64 << 20;

export const DRAWING_TYPE = 'image/svg+xml';

/** Writes straight RGBA as a PNG. */
export type WritePng = (rgba: Uint8Array<ArrayBuffer>, width: number, height: number) => Promise<Blob>;

/** @throws C2WarpError for a drawing that cannot be read, or that would take too long to draw. */
export async function readDrawing(
  { request: { kind, file }, module }: DrawingOrder,
  writePng: WritePng,
): Promise<DrawingReplies[keyof DrawingReplies]> {
  const text = await textOf(file);
  if (text === null) return null;
  await init({ module_or_path: module }).catch((cause: unknown) => {
    throw pictureError('engine', say('errors.picture.drawingUnread'), { cause });
  });
  return kind === 'picture' ? pictureOf(text, writePng) : plainOf(text);
}

/** The text of a drawing; null for a compressed file that is none. */
async function textOf(file: Blob): Promise<string | null> {
  if (file.size > MOST_BYTES) throw pictureError('picture', say('errors.picture.drawingTooLarge'));
  const start = new DataView(await readBytes(file.slice(0, 3)));
  const isPacked = signatureOf(start).name === 'compressed';
  const unpacked = isPacked ? await unpackedDrawing(file, MOST_BYTES) : file;
  if (!unpacked) return null;
  const read = xmlText(await readBytes(unpacked));
  if ('text' in read) return read.text;
  throw pictureError('picture', say('errors.picture.drawingEncoding', read.unreadableAs));
}

async function pictureOf(text: string, writePng: WritePng): Promise<ReadPicture> {
  const { sized, width, height } = sizedDrawing(text);
  const drawing = attempt(() => new ReadDrawing(sized));
  const isLight = attempt(() => drawing.isLight(width, height));
  const rgba = isLight ? null : attempt(() => drawing.pixels(width, height));
  return {
    file: new Blob([text], { type: DRAWING_TYPE }),
    pixels: rgba && (await writePng(rgba, width, height)),
    sized: new Blob([sized], { type: DRAWING_TYPE }),
    width,
    height,
    lacksTexts: !isLight && drawing.hasTexts,
  };
}

function plainOf(text: string): DrawingReplies['plain'] {
  const drawing = attempt(() => new ReadDrawing(text));
  const [width = 0, height = 0] = drawing.size;
  return { svg: drawing.plain, width, height, remarks: drawing.remarks };
}

function attempt<T>(act: () => T): T {
  try {
    return act();
  } catch (cause) {
    throw refused(cause);
  }
}

/** The reasons of the module by their names. Anything else is a panic, nearly always for want of memory. */
function refused(cause: unknown): C2WarpError {
  const { name, cause: detail } = cause instanceof Error ? cause : new Error();
  return pictureError('picture', wordingOf(name, detail), { cause });
}

function wordingOf(name: string, detail: unknown): Wording {
  switch (name) {
    case 'TooLarge':
      return say('errors.picture.drawingTooLarge');
    case 'TooManyElements':
      return say('errors.picture.drawingTooManyElements', Number(detail));
    case 'TooManyAttributes':
      return say('errors.picture.drawingTooManyAttributes', Number(detail));
    case 'TooDeep':
      return say('errors.picture.drawingTooDeep', Number(detail));
    case 'TooManyCopies':
      return say('errors.picture.drawingTooManyCopies');
    case 'TooManyStyles':
      return say('errors.picture.drawingTooManyStyles');
    case 'TooSlow':
      return say('errors.picture.drawingTooSlow', String(detail));
    case 'TooMuchMemory':
      return say('errors.picture.drawingTooMuchMemory', String(detail));
    case 'NoSize':
      return say('errors.picture.drawingWithoutSize');
    default:
      return say('errors.picture.drawingDamaged');
  }
}
