/** The open picture as the editor knows it: its size and what its pixels suggest. The runtime holds the pixels. */

import type { Project } from '../document/project';
import { C2WarpError } from '../error';
import type { Size } from '../geometry/camera';
import { en } from '../texts/en';
import { say, worded } from '../texts/wording';

/** A file that the editor passes on unread: a `Blob` of the runtime. */
export interface SourceFile {
  readonly size: number;
  readonly type: string;
}

/** A file with its name, as it was chosen, dropped or pasted. */
export interface NamedFile {
  readonly name: string;
  readonly file: SourceFile;
  /** A dropped folder. */
  readonly folder?: boolean;
}

export interface Picture extends Size {
  /** Tells apart pictures of the same name. */
  readonly id: string;
  /** The file name that the project file refers to. */
  readonly name: string;
  /** The address of a small picture. */
  readonly thumbnail: string;
  /** The original file, stored for the next visit. */
  readonly file: SourceFile;
  /** The alpha threshold of a picture with transparency; null for an opaque picture. */
  readonly alphaThreshold: number | null;
  /** Whether the picture is small enough for pixel art. */
  readonly isSmall: boolean;
  /** Whether it looks like pixel art: small, few colours, no soft edges. */
  readonly isPixelArt: boolean;
  /** Whether the file has several frames. The picture is the first. */
  readonly moves: boolean;
  /** Whether texts of the drawing are missing in the picture. */
  readonly lacksTexts: boolean;
}

/** Whether a picture was made from an SVG drawing, which it then keeps as its file. */
export const isDrawing = ({ file }: Pick<Picture, 'file'>): boolean => file.type === 'image/svg+xml';

export const isOpaque = (picture: Picture | null): boolean => picture?.alphaThreshold === null;

export const fits = (picture: Size, project: Project): boolean =>
  picture.width === project.image.width && picture.height === project.image.height;

/** Whether a project was made for this very picture: of its size, and of its name where the project has one. */
export const belongs = (picture: Pick<Picture, 'name'> & Size, project: Project): boolean =>
  fits(picture, project) && ['', picture.name].includes(fileNameOf(project.image.src));

/** The last part of a path: project files may lie in another folder than their pictures. */
const fileNameOf = (src: string): string => src.split(/[/\\]/).at(-1) ?? '';

/** The error for a project that belongs to a picture of another size; null if the size fits. */
export function misfit(picture: Picture, project: Project): C2WarpError | null {
  if (fits(picture, project)) return null;
  const { width, height } = project.image;
  const wording = say('errors.imageSize', width, height, picture.name, picture.width, picture.height);
  return new C2WarpError('image-size', worded(en, wording), { wording });
}

/** A name as a part of a file's name: characters that it cannot have become hyphens. */
export const fileWord = (name: string): string => name.replaceAll(/[\\/:*?"<>|\s]+/g, '-');

/** "cat.png" → "cat". */
export const stem = (name: string): string => name.replace(/(\.c2warp)?\.[^.]+$/, '') || name;
