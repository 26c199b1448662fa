/** Files that the person chooses: through the browser's own file system access where it has it, else by up- and download. */
import { type FileWithHandle, fileOpen, fileSave } from 'browser-fs-access';

const KINDS = {
  picture: {
    description: 'Pictures',
    mimeTypes: ['image/*'],
    extensions: ['.png', '.jpg', '.jpeg', '.webp', '.avif', '.gif', '.bmp'],
  },
  project: { description: 'c2warp projects', mimeTypes: ['application/json'], extensions: ['.json'] },
  any: {
    description: 'Pictures and c2warp projects',
    mimeTypes: ['image/*', 'application/json'],
    extensions: ['.png', '.jpg', '.jpeg', '.webp', '.avif', '.gif', '.bmp', '.json'],
  },
  png: { description: 'PNG pictures', mimeTypes: ['image/png'], extensions: ['.png'] },
};

/** Asks for a file to open; undefined where the person thinks better of it. */
export function openFile(kind: 'picture' | 'project' | 'any'): Promise<FileWithHandle | undefined> {
  return unlessCancelled(fileOpen({ ...KINDS[kind], multiple: false, id: kind }));
}

/**
 * Asks where to save a file of this name; false where the person thinks better of it. A blob that takes time to make is
 * given as a promise, since the browser only asks while the click that led here is fresh.
 */
export async function saveFile(
  blob: Blob | Promise<Blob>,
  fileName: string,
  kind: 'project' | 'png',
): Promise<boolean> {
  const saved = await unlessCancelled(
    fileSave(blob, { ...KINDS[kind], fileName, id: kind }).then(() => true),
  );
  return saved ?? false;
}

async function unlessCancelled<T>(choice: Promise<T>): Promise<T | undefined> {
  try {
    return await choice;
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return undefined;
    throw error;
  }
}
