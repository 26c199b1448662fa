/** Opens and saves files that the user picks: with the File System Access API, or else by upload and download. */
import { type FileWithHandle, fileOpen, fileSave } from 'browser-fs-access';

const KINDS = {
  project: { description: 'c2warp projects', mimeTypes: ['application/json'], extensions: ['.json'] },
  any: {
    description: 'Pictures and c2warp projects',
    mimeTypes: ['image/*', 'application/json'],
    extensions: ['.png', '.jpg', '.jpeg', '.webp', '.avif', '.gif', '.bmp', '.json'],
  },
  svg: { description: 'SVG figures', mimeTypes: ['image/svg+xml'], extensions: ['.svg'] },
  png: { description: 'PNG pictures', mimeTypes: ['image/png'], extensions: ['.png'] },
  jpeg: { description: 'JPEG pictures', mimeTypes: ['image/jpeg'], extensions: ['.jpg', '.jpeg'] },
  webp: { description: 'WebP pictures', mimeTypes: ['image/webp'], extensions: ['.webp'] },
};

type Kind = keyof typeof KINDS;

/** Asks for a picture or a project to open. Returns undefined if the user cancels. */
export function openFile(): Promise<FileWithHandle | undefined> {
  return unlessCancelled(fileOpen({ ...KINDS.any, multiple: false, id: 'any' }));
}

/**
 * Asks where to save a file, and saves it. Returns its name, or null if the user cancels or the blob is an AbortError.
 *
 * Browsers ask only shortly after a click: pass a blob that takes time to make as a promise.
 */
export async function saveFile(
  blob: Blob | Promise<Blob>,
  fileName: string,
  kind: Kind,
): Promise<string | null> {
  let chosen: FileSystemFileHandle | null = null;
  const choose = (handle: FileSystemFileHandle | null) => {
    chosen = handle;
  };
  // After a cancel, nobody awaits the blob.
  if (blob instanceof Promise) blob.catch(() => {});
  try {
    const options = { ...KINDS[kind], fileName, id: kind };
    const handle = await unlessCancelled(fileSave(blob, options, null, false, choose));
    if (handle !== undefined) return handle?.name ?? fileName;
  } catch (error) {
    await removeEmpty(chosen);
    throw error;
  }
  await removeEmpty(chosen);
  return null;
}

/** Removes the empty file that browsers create when the user names a new one, if nothing was written to it. */
async function removeEmpty(
  handle: (FileSystemFileHandle & { remove?(): Promise<void> }) | null,
): Promise<void> {
  try {
    if (handle && (await handle.getFile()).size === 0) await handle.remove?.();
  } catch {
    // It is gone already, or may not be removed.
  }
}

async function unlessCancelled<T>(choice: Promise<T>): Promise<T | undefined> {
  try {
    return await choice;
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return undefined;
    throw error;
  }
}
