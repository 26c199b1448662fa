/** Opens and saves files that the user picks: with the File System Access API, or else by upload and download. */
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

/** Asks for a picture or a project to open. Returns undefined if the user cancels. */
export function openFile(): Promise<FileWithHandle | undefined> {
  return unlessCancelled(fileOpen({ ...KINDS.any, multiple: false, id: 'any' }));
}

/**
 * Asks where to save a file, and saves it. Returns false if the user cancels.
 *
 * Browsers ask only shortly after a click: pass a blob that takes time to make as a promise.
 */
export async function saveFile(blob: Blob | Promise<Blob>, fileName: string, kind: Kind): Promise<boolean> {
  const saved = fileSave(blob, { ...KINDS[kind], fileName, id: kind }).then(() => true);
  // After a cancel, nobody awaits the blob.
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
