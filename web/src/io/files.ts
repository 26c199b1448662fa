/** Files that the person chooses: by the browser's file system access where available, else by up- and download. */
import { type FileWithHandle, fileOpen, fileSave } from 'browser-fs-access';

const KINDS = {
  project: { description: 'c2warp projects', mimeTypes: ['application/json'], extensions: ['.json'] },
  any: {
    description: 'Pictures and c2warp projects',
    mimeTypes: ['image/*', 'application/json'],
    extensions: ['.png', '.jpg', '.jpeg', '.webp', '.avif', '.gif', '.bmp', '.json'],
  },
  png: { description: 'PNG pictures', mimeTypes: ['image/png'], extensions: ['.png'] },
};

type Kind = keyof typeof KINDS;

/** Asks for a picture or a project to open; undefined when the person cancels. */
export function openFile(): Promise<FileWithHandle | undefined> {
  return unlessCancelled(fileOpen({ ...KINDS.any, multiple: false, id: 'any' }));
}

/**
 * Asks where to save a file of this name; saves nothing when the person cancels. Pass a blob that takes time to make as
 * a promise, since the browser only asks while the click that led here is fresh.
 *
 * @returns whether it was saved.
 */
export async function saveFile(blob: Blob | Promise<Blob>, fileName: string, kind: Kind): Promise<boolean> {
  const saved = fileSave(blob, { ...KINDS[kind], fileName, id: kind }).then(() => true);
  // Nobody waits for it once the person cancels.
  if (blob instanceof Promise) blob.catch(() => {});
  return (await unlessCancelled(saved)) ?? false;
}

async function unlessCancelled<T>(choice: Promise<T>): Promise<T | undefined> {
  try {
    return await choice;
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return undefined;
    throw error;
  }
}
