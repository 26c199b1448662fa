/**
 * Projects that hold their picture: `image.src` is a `data:` URL whose parameter `name` is the file's name.
 *
 * Opened, they are split, since the history would repeat the picture in each of its steps.
 */
import type { Project } from '../document/project';
import type { NamedFile } from '../editor/picture';
import { dataFile } from '../io/address';

/** The keyword of the text in a PNG file that is a project. */
export const KEYWORD = 'c2warp';

/** A project as text, and the picture that it held, or null. */
export interface SplitProject {
  readonly text: string;
  readonly picture: NamedFile | null;
}

/** @throws C2WarpError if the picture in the text is damaged. */
export function splitProject(text: string): SplitProject {
  const whole = parsed(text);
  const src = whole?.image?.src;
  if (typeof src !== 'string' || !/^data:/i.test(src)) return { text, picture: null };
  const name = nameOf(src);
  const project = { ...whole, image: { ...whole?.image, src: name } };
  return { text: JSON.stringify(project), picture: { name, file: dataFile(src) } };
}

/** The project with its picture in it. */
export async function joinedProject(project: Project, { name, file }: NamedFile): Promise<Project> {
  const address = await new Promise<string>((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(file as Blob);
  });
  const [, type, content] = /^data:([^;,]*)(.*)$/s.exec(address) ?? [];
  const src = `data:${type || 'image/png'};name=${encodeURIComponent(name)}${content}`;
  return { ...project, image: { ...project.image, src } };
}

function parsed(text: string): { readonly image?: { readonly src?: unknown } } | null {
  try {
    return JSON.parse(text);
  } catch {
    // The solver reports what is wrong with it.
    return null;
  }
}

function nameOf(address: string): string {
  const [, name = ''] = /^data:[^,]*?;name=([^;,]*)/i.exec(address) ?? [];
  try {
    return decodeURIComponent(name) || 'picture.png';
  } catch {
    // A stray percent sign.
    return name;
  }
}
