/** The open picture, and how files become one. */
import type { Project } from '../document/project';
import { type DecodedPicture, decodePicture } from '../io/decode';

export interface Picture extends DecodedPicture {
  /** File name, as the project file refers to it. */
  readonly name: string;
  /** The file as it was opened: what is kept for the next visit. */
  readonly file: Blob;
}

/** @throws Error with a code, its message led by the file's name. */
export async function readPicture(file: Blob, name: string): Promise<Picture> {
  try {
    return { ...(await decodePicture(file)), name, file };
  } catch (error) {
    throw ofFile(name, error);
  }
}

/** An error, its message led by the file's name. */
export function ofFile(name: string, error: unknown): unknown {
  // The message of a DOMException, such as that the editor is gone, cannot be set.
  if (error instanceof Error && !(error instanceof DOMException)) error.message = `${name}: ${error.message}`;
  return error;
}

export const fits = (picture: Picture | null, project: Project): boolean =>
  picture?.width === project.image.width && picture.height === project.image.height;

/** What is wrong where they do not fit. */
export function misfit(picture: Picture, project: Project): RangeError | null {
  if (fits(picture, project)) return null;
  const { width, height } = project.image;
  const message = `The project is for a picture of ${width} × ${height} px; ${picture.name} has ${picture.width} × ${picture.height} px.`;
  return Object.assign(new RangeError(message), { code: 'image-size' });
}

/** What was dropped, pasted or chosen: the first picture, the first project. Anything unknown counts as a picture. */
export function sortFiles(files: readonly File[]): { picture?: File; project?: File } {
  const isProject = (file: File) => /\.json$/i.test(file.name) || file.type === 'application/json';
  const picture = files.find((file) => !isProject(file));
  const project = files.find(isProject);
  return { ...(picture && { picture }), ...(project && { project }) };
}

/** "cat.png" → "cat". */
export const stem = (name: string): string => name.replace(/(\.c2warp)?\.[^.]+$/, '') || name;
