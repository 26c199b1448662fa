/** Errors of pictures and of the files that they are in. */
import { number } from './language';

export const pictureErrors = {
  empty: 'The file is empty.',
  unreadable: 'The file cannot be read: it is a folder, or it was moved or changed. Choose the file again.',
  incomplete: 'The picture is incomplete: the end of the file is missing. Get the file again.',
  unknown: 'The file is not a picture that this browser can read. Use PNG, JPEG or WebP.',
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
    `The picture is ${width} × ${height} px. A side can be at most ${number(most)} px: scale the picture down.`,
  tooLarge: (width: number, height: number, millions: number) =>
    `The picture is ${width} × ${height} px. It can have at most ${millions} million pixels: scale the picture down.`,
  drawingDamaged: 'The drawing is damaged, or this browser cannot show it.',
  drawingWithoutSize: 'The drawing has no size. Give it a width and a height, or a viewBox.',
  drawingTooLarge: 'The drawing has more than 64 MB. Simplify it.',
  drawingEncoding: (encoding: string) => `The drawing cannot be read as ${encoding}. Save it as UTF-8.`,
  drawingUnread: 'The drawing could not be read. Check your connection, and open it again.',
  drawingTooManyElements: (most: number) =>
    `The drawing has more than ${number(most)} elements. Simplify it.`,
  drawingTooManyAttributes: (most: number) =>
    `An element of the drawing has more than ${most} attributes. Remove some.`,
  drawingTooDeep: (most: number) =>
    `Elements of the drawing are nested more than ${most} deep. Ungroup some.`,
  drawingTooManyCopies: 'Elements of the drawing are used too often. Use smaller ones, or use them less.',
  drawingTooManyStyles: 'The style sheets of the drawing take too long. Simplify them.',
  /** @param element the name of an element, such as feTurbulence. */
  drawingTooSlow: (element: string) =>
    `The drawing takes too long to draw, most of all its <${element}>. Simplify it.`,
  drawingTooMuchMemory: (element: string) =>
    `The drawing takes too much memory to draw, most of all its <${element}>. Simplify it.`,
  noWebgl:
    'This browser cannot read pictures with WebGL2. Switch on hardware acceleration or use another browser.',
  contextLost: 'The graphics context was lost while the picture was read. Open the picture again.',
};

/** Errors of addresses. */
export const addressErrors = {
  /** @param status the number that the server answered, such as 404. */
  status: (file: string, status: number) => `${file} could not be loaded: the server answered ${status}.`,
  webPage: (file: string) =>
    `${file} could not be loaded: it is a web page. Give the address of the picture itself.`,
  unreachable: (file: string) => `${file} could not be loaded. Check the address and the network connection.`,
  refused: (file: string, host: string) =>
    `${file} could not be loaded. ${host} does not let this page read it (CORS), or cannot be reached. Save the picture, and open the file.`,
  damaged: 'The picture in the address is damaged. Copy it again, or save it as a file.',
};

/** Errors of projects in pictures. */
export const carriedErrors = {
  tooLong: 'The project in this picture is too long.',
  damaged: 'The project in this picture is damaged.',
  compressed: 'The project in this picture is compressed, which is not supported.',
};
