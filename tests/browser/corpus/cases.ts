/**
 * Picture files, and how the editor and the command treat each. `oddity` is a row of `web/docs/pictures.md`.
 *
 * Most files show `FLAG`, whose upper left is red. Where both open a file, the test compares all of its pixels.
 */
import { BLUE, type Bytes, type Colour, CYAN, exif, FLAG, flat, latin, RED, YELLOW } from './bytes';
import { gif } from './gif';
import * as jpeg from './jpeg';
import { AVIF, BMP, LOSSY } from './pictures';
import * as png from './png';
import * as webp from './webp';

/** The size and the colour at the upper left, or the reason of a refusal. */
export type Outcome =
  | { readonly size: readonly [number, number]; readonly first: Colour; readonly moves?: true }
  | RegExp;

export interface Case {
  readonly oddity: string;
  readonly title: string;
  readonly file: Bytes;
  readonly editor: Outcome;
  /** Like the editor if left out. */
  readonly command?: Outcome;
}

const WHITE: Colour = [255, 255, 255, 255];
const CLEAR: Colour = [0, 0, 0, 0];

const opened = (width = 3, height = 2, first = RED) => ({ size: [width, height], first }) as const;
const moving = (first = RED) => ({ size: [3, 2], first, moves: true }) as const;
const blocks = opened(24, 16);
const incomplete = /is incomplete|damaged or truncated/;
const damaged = /is damaged|damaged or truncated/;
const named = (name: string) => new RegExp(`this is ${name}\\W+save it as PNG, JPEG or WebP`, 'i');

/** The upper left of `FLAG` in each orientation, and whether its sides are exchanged. */
const ORIENTATIONS: readonly (readonly [orientation: number, first: Colour, exchanged: boolean])[] = [
  [2, BLUE, false],
  [3, CYAN, false],
  [4, YELLOW, false],
  [5, RED, true],
  [6, YELLOW, true],
  [7, CYAN, true],
  [8, BLUE, true],
];

const lossyWith = (flags: number, chunks: Bytes) =>
  webp.extended(flags, chunks, { ...FLAG, width: 24, height: 16 });
const { alpha, animation } = webp.FLAGS;

export const CASES: readonly Case[] = [
  { oddity: 'PNG', title: 'rgba', file: png.png(), editor: opened() },
  { oddity: 'PNG', title: 'rgb', file: png.png({ channels: 3 }), editor: opened() },
  {
    oddity: 'PNG',
    title: 'palette',
    file: png.pngOfType(
      8,
      3,
      [
        [0, 1, 2],
        [2, 1, 0],
      ],
      [...png.chunk('PLTE', [255, 0, 0, 0, 255, 0, 0, 0, 255]), ...png.chunk('tRNS', [255, 128])],
    ),
    editor: opened(),
  },
  {
    oddity: 'PNG',
    title: 'grey of 1 bit',
    file: png.pngOfType(1, 0, [[0b10100000], [0b01000000]]),
    editor: opened(3, 2, WHITE),
  },
  {
    oddity: 'PNG',
    title: 'grey with alpha',
    file: png.pngOfType(8, 4, [
      [255, 255, 128, 128, 7, 0],
      [1, 2, 3, 4, 5, 6],
    ]),
    editor: opened(3, 2, WHITE),
  },
  {
    oddity: 'PNG',
    title: 'a transparent colour',
    file: png.pngOfType(
      8,
      2,
      [
        [255, 0, 0, 1, 2, 3, 1, 2, 4],
        [9, 9, 9, 1, 2, 3, 5, 5, 5],
      ],
      png.chunk('tRNS', [0, 1, 0, 2, 0, 3]),
    ),
    editor: opened(),
  },
  { oddity: '16 bits', title: '16 bits', file: png.deepPng(), editor: opened() },
  {
    oddity: 'PNG',
    title: 'an unknown chunk',
    file: png.png({ before: png.chunk('teSt', [1, 2, 3]) }),
    editor: opened(),
  },
  {
    oddity: 'wrong checksum',
    title: 'a wrong checksum of a text',
    file: png.png({ before: png.chunk('tEXt', latin('a\0b'), 7) }),
    editor: opened(),
  },
  {
    oddity: 'wrong checksum',
    title: 'a wrong checksum of the pixels',
    file: png.png({ before: png.chunk('IDAT', png.pixelData(FLAG), 7) }),
    editor: damaged,
  },
  { oddity: 'cut short', title: 'png cut short', file: png.png().slice(0, 70), editor: incomplete },
  { oddity: 'cut short', title: 'png without IEND', file: png.png({ end: [] }), editor: incomplete },
  {
    oddity: 'data behind the end',
    title: 'data behind IEND',
    file: [...png.png(), ...latin('trailer')],
    editor: opened(),
  },
  {
    oddity: 'too small or too large',
    title: 'one pixel',
    file: png.png({ pixels: flat(RED, 1, 1) }),
    editor: /1 [×x] 1|1×1/,
  },
  {
    oddity: 'too small or too large',
    title: 'a billion pixels',
    file: [...latin('\x89PNG\r\n\x1a\n'), ...png.header(60_000, 60_000, 8, 6), ...png.png().slice(33)],
    editor: /60000/,
  },
  {
    oddity: 'EXIF orientation',
    title: 'png turned by 6',
    file: png.png({ before: png.chunk('eXIf', exif(6)) }),
    editor: opened(2, 3, YELLOW),
  },
  {
    oddity: 'EXIF orientation',
    title: 'png turned by 8, big-endian',
    file: png.png({ before: png.chunk('eXIf', exif(8, 'MM')) }),
    editor: opened(2, 3, BLUE),
  },
  {
    oddity: 'animation',
    title: 'apng with its default picture as first frame',
    file: png.png({
      before: [...png.animation(2), ...png.frameControl(0)],
      after: [...png.frameControl(1), ...png.frameData(2, flat(BLUE))],
    }),
    editor: moving(),
  },
  {
    oddity: 'animation without its default picture',
    title: 'apng whose default picture is no frame',
    file: png.png({
      before: png.animation(2),
      after: [
        ...[...png.frameControl(0), ...png.frameData(1, flat(YELLOW))],
        ...[...png.frameControl(2), ...png.frameData(3, flat(BLUE))],
      ],
    }),
    editor: moving(YELLOW),
  },
  {
    oddity: 'animation without its default picture',
    title: 'apng whose first frame is small',
    file: png.png({
      before: png.animation(2),
      after: [
        ...[...png.frameControl(0, flat(CYAN, 1, 1), [1, 1]), ...png.frameData(1, flat(CYAN, 1, 1))],
        ...[...png.frameControl(2), ...png.frameData(3, flat(BLUE))],
      ],
    }),
    editor: moving(CLEAR),
  },
  {
    oddity: 'animation without frames',
    title: 'apng without frames',
    file: png.png({ before: png.animation(1) }),
    editor: damaged,
  },

  { oddity: 'JPEG', title: 'jpeg', file: jpeg.jpeg(), editor: blocks },
  { oddity: 'JPEG', title: 'grey jpeg', file: jpeg.jpeg({ scale: 'grey' }), editor: opened(24, 16, WHITE) },
  { oddity: 'JPEG', title: 'progressive jpeg', file: jpeg.progressiveJpeg(), editor: blocks },
  { oddity: 'JPEG', title: 'restarts', file: jpeg.jpeg({ restarts: true }), editor: blocks },
  {
    oddity: 'JPEG',
    title: 'rgb jpeg',
    file: jpeg.jpeg({ scale: 'plain', before: jpeg.adobe(0) }),
    editor: blocks,
  },
  {
    oddity: 'CMYK',
    title: 'cmyk jpeg',
    file: jpeg.jpeg({ scale: 'print', before: jpeg.adobe(0) }),
    editor: blocks,
  },
  ...ORIENTATIONS.map(
    ([orientation, first, exchanged]): Case => ({
      oddity: 'EXIF orientation',
      title: `jpeg turned by ${orientation}`,
      file: jpeg.jpeg({ before: jpeg.exifSegment(exif(orientation, orientation % 2 ? 'II' : 'MM')) }),
      editor: exchanged ? opened(16, 24, first) : opened(24, 16, first),
    }),
  ),
  {
    oddity: 'EXIF orientation',
    title: 'jpeg turned by 9',
    file: jpeg.jpeg({ before: jpeg.exifSegment(exif(9)) }),
    editor: blocks,
  },
  {
    oddity: 'EXIF orientation',
    title: 'jpeg with broken exif',
    file: jpeg.jpeg({ before: jpeg.exifSegment(exif(6).slice(0, 11)) }),
    editor: blocks,
  },
  { oddity: 'no end marker', title: 'jpeg without end', file: jpeg.jpeg({ end: [] }), editor: blocks },
  {
    oddity: 'no end marker',
    title: 'jpeg with a trailer for its end',
    file: jpeg.jpeg({ end: latin('trailer of a phone') }),
    editor: blocks,
  },
  {
    oddity: 'no end marker',
    title: 'jpeg with markers in its trailer',
    file: jpeg.jpeg({ end: [0xff, 0xe5, 0, 9, ...latin('trail')] }),
    editor: blocks,
  },
  {
    oddity: 'no end marker',
    title: 'progressive jpeg without end',
    file: jpeg.progressiveJpeg({ end: [] }),
    editor: blocks,
  },
  {
    oddity: 'cut short',
    title: 'jpeg cut in its scan',
    file: jpeg.jpeg({ end: [] }).slice(0, -4),
    editor: incomplete,
  },
  {
    oddity: 'cut short',
    title: 'jpeg cut by two bytes',
    file: jpeg.jpeg({ end: [] }).slice(0, -2),
    editor: incomplete,
  },
  {
    oddity: 'cut short',
    title: 'progressive jpeg without its last scan',
    file: jpeg.progressiveJpeg({ end: [], scans: 4 }),
    editor: incomplete,
  },
  {
    oddity: 'cut short',
    title: 'jpeg without a scan',
    file: jpeg.jpeg().slice(0, 100),
    editor: incomplete,
  },
  {
    oddity: 'data behind the end',
    title: 'data behind the end of a jpeg',
    file: [...jpeg.jpeg(), ...jpeg.jpeg().slice(0, 99)],
    editor: blocks,
  },

  { oddity: 'WebP', title: 'lossless webp', file: webp.riff(webp.lossless()), editor: opened() },
  { oddity: 'WebP', title: 'lossy webp', file: webp.riff(LOSSY), editor: blocks },
  {
    oddity: 'WebP',
    title: 'webp with an unknown chunk',
    file: webp.extended(alpha, [...webp.chunk('ABCD', [1, 2, 3]), ...webp.lossless()]),
    editor: opened(),
  },
  {
    oddity: 'WebP',
    title: 'webp with separate alpha',
    file: lossyWith(alpha, [...webp.chunk('ALPH', [0, ...new Array(24 * 16).fill(255)]), ...LOSSY]),
    editor: blocks,
  },
  ...ORIENTATIONS.filter(([orientation]) => orientation > 4).map(
    ([orientation, first]): Case => ({
      oddity: 'EXIF orientation',
      title: `webp turned by ${orientation}`,
      file: webp.extended(alpha | webp.FLAGS.exif, [
        ...webp.lossless(),
        ...webp.chunk('EXIF', [...(orientation === 7 ? latin('Exif\0\0') : []), ...exif(orientation)]),
      ]),
      editor: opened(2, 3, first),
    }),
  ),
  ...(['alpha', 'exif', 'xmp', 'profile'] as const).map(
    (flag): Case => ({
      oddity: 'flag without its chunk',
      title: `webp with the flag ${flag} alone`,
      file: lossyWith(webp.FLAGS[flag], LOSSY),
      editor: blocks,
    }),
  ),
  {
    oddity: 'animation',
    title: 'animated webp',
    file: webp.extended(alpha | animation, [
      ...webp.animationControl,
      ...webp.animationFrame(FLAG),
      ...webp.animationFrame(flat(BLUE)),
    ]),
    editor: moving(),
  },
  {
    oddity: 'cut short',
    title: 'webp cut short',
    file: webp.riff(webp.lossless()).slice(0, -6),
    editor: incomplete,
  },
  {
    oddity: 'data behind the end',
    title: 'data behind a webp',
    file: [...webp.riff(webp.lossless()), ...latin('trailer')],
    editor: opened(),
  },

  { oddity: 'GIF', title: 'gif', file: gif(FLAG), editor: opened(), command: named('a GIF picture') },
  {
    oddity: 'animation',
    title: 'animated gif',
    file: gif(FLAG, flat(BLUE)),
    editor: moving(),
    command: named('a GIF picture'),
  },
  { oddity: 'BMP', title: 'bmp', file: BMP, editor: opened(), command: named('a BMP picture') },
  {
    oddity: 'AVIF',
    title: 'avif',
    file: AVIF,
    editor: { size: [2, 2], first: WHITE },
    command: named('an AVIF picture'),
  },
  ...(
    [
      ['HEIC', 'a HEIC picture', '\0\0\0\x18ftypheic\0\0\0\0mif1heic'],
      ['TIFF', 'a TIFF picture', 'II*\0\b\0\0\0\0\0'],
      ['Photoshop', 'a Photoshop document', '8BPS\0\x01\0\0\0\0\0\0'],
      ['PDF', 'a PDF document', '%PDF-1.7\n'],
    ] as const
  ).map(
    ([oddity, name, text]): Case => ({
      oddity,
      title: name,
      file: latin(text),
      editor: named(name),
    }),
  ),
  {
    oddity: 'SVG',
    title: 'drawing',
    file: latin(
      '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 3 2"><path d="M0 0h3v2H0z" fill="red"/></svg>',
    ),
    editor: named('an SVG drawing'),
    command: opened(),
  },
  {
    oddity: 'no picture',
    title: 'text',
    file: latin('once upon a time'),
    editor: /cannot read the file as a picture/,
    command: /is not a PNG, JPEG, WebP or SVG picture/,
  },
  { oddity: 'no picture', title: 'nothing', file: [], editor: /file is empty/ },
];
