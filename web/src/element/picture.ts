/** The open picture, and how it is read from a file. */
import type { Project } from '../document/project';
import { type DecodedPicture, decodePicture } from '../io/decode';

export interface Picture extends DecodedPicture {
  /** The file name that the project file refers to. */
  readonly name: string;
  /** The original file, stored for the next visit. */
  readonly file: Blob;
}

/** @throws Error with a `code` and a message that begins with the file's name. */
export async function readPicture(file: Blob, name: string): Promise<Picture> {
  try {
    return { ...(await decodePicture(file)), name, file };
  } catch (error) {
    throw ofFile(name, error);
  }
}

/** The same error, with the file's name before its message. */
export function ofFile(name: string, error: unknown): unknown {
  // The message of a DOMException, such as an AbortError, is read-only.
  if (error instanceof Error && !(error instanceof DOMException)) error.message = `${name}: ${error.message}`;
  return error;
}

export const fits = (picture: Picture | null, project: Project): boolean =>
  picture?.width === project.image.width && picture.height === project.image.height;

/** An error if the project is for a picture of another size, else null. */
export function misfit(picture: Picture, project: Project): RangeError | null {
  if (fits(picture, project)) return null;
  const { width, height } = project.image;
  const message = `The project is for a picture of ${width} × ${height} px; ${picture.name} has ${picture.width} × ${picture.height} px.`;
  return Object.assign(new RangeError(message), { code: 'image-size' });
}

/** The first picture and the first project of some files. Every file that is not JSON counts as a picture. */
export function sortFiles(files: readonly File[]): { picture?: File; project?: File } {
  const isProject = (file: File) => /\.json$/i.test(file.name) || file.type === 'application/json';
  const picture = files.find((file) => !isProject(file));
  const project = files.find(isProject);
  return { ...(picture && { picture }), ...(project && { project }) };
}

/** "cat.png" → "cat". */
export const stem = (name: string): string => name.replace(/(\.c2warp)?\.[^.]+$/, '') || name;
