/** Errors of pictures and of the files that they are in. */
import { number } from './language';

export const pictureErrors = {
  empty: 'The file is empty.',
  unreadable: 'Could not read the file. It is a folder, or it was moved or changed. Choose the file again.',
  incomplete: 'The picture is incomplete: the end of the file is missing. Download or copy the file again.',
  unknown: 'This browser cannot read the file as a picture. Use PNG, JPEG or WebP.',
  /** @param kind one of `kinds`. */
  otherKind: (kind: string) => `This is ${kind}. Save it as PNG, JPEG or WebP.`,
  kinds: {
    png: 'a PNG picture',
    jpeg: 'a JPEG picture',
    gif: 'a GIF picture',
    webp: 'a WebP picture',
    avif: 'an AVIF picture',
    heic: 'a HEIC picture',
    bmp: 'a BMP picture',
    icon: 'an icon',
    tiff: 'a TIFF picture',
    photoshop: 'a Photoshop document',
    pdf: 'a PDF document',
    postscript: 'a PostScript document',
    jpegXl: 'a JPEG XL picture',
    jpeg2000: 'a JPEG 2000 picture',
    svg: 'an SVG drawing',
    compressed: 'a compressed file',
  },
  damaged: 'The picture is damaged, or this browser cannot read it. Save it again as PNG, JPEG or WebP.',
  tooSmall: (width: number, height: number, least: number) =>
    `The picture is ${width} × ${height} px. It must be at least ${least} × ${least} px.`,
  tooLong: (width: number, height: number, most: number) =>
    `The picture is ${width} × ${height} px. Each side can be at most ${number(most)} px. Scale the picture down.`,
  tooLarge: (width: number, height: number, millions: number) =>
    `The picture is ${width} × ${height} px. It can have at most ${millions} million pixels. Scale it down.`,
  drawingDamaged: 'The drawing is damaged, or this browser cannot show it.',
  drawingWithoutSize: 'The drawing has no size. Give it a width and a height, or a viewBox.',
  drawingTooLarge: 'The drawing is larger than 64 MB. Simplify it.',
  drawingEncoding: (encoding: string) => `The drawing cannot be read as ${encoding}. Save it as UTF-8.`,
  /** @param detail a sentence in English. */
  drawingRefused: (detail: string) => detail,
  noWebgl:
    'This browser cannot read pictures with WebGL2. Turn on hardware acceleration or use another browser.',
  contextLost:
    'The browser lost access to the graphics card while reading the picture. Open the picture again.',
};

/** Errors of addresses. */
export const addressErrors = {
  /** @param status the number that the server answered, such as 404. */
  status: (file: string, status: number) => `Could not load ${file}: the server answered ${status}.`,
  webPage: (file: string) => `${file} is a web page. Enter the address of the picture itself.`,
  unreachable: (file: string) => `Could not load ${file}. Check the address and your connection.`,
  refused: (file: string, host: string) =>
    `Could not load ${file}. ${host} does not let this page read it (CORS), or cannot be reached. Save the picture, then open the file.`,
  damaged: 'The picture in the address is damaged. Copy it again, or save it as a file.',
};

/** Errors of projects in pictures. */
export const carriedErrors = {
  tooLong: 'The project in this picture is too large.',
  damaged: 'The project in this picture is damaged.',
  compressed: 'The project in this picture is compressed. The editor reads only uncompressed projects.',
};
