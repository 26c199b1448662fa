/** Opens and saves files that the user picks: with the File System Access API, or else by upload and download. */
import { type FileWithHandle, fileOpen, fileSave, supported } from 'browser-fs-access';

const KINDS = {
  project: { description: 'c2warp projects', mimeTypes: ['application/json'], extensions: ['.json'] },
  any: {
    description: 'Pictures and c2warp projects',
    mimeTypes: ['image/*', 'application/json'],
    extensions: ['.png', '.jpg', '.jpeg', '.webp', '.svg', '.svgz', '.avif', '.gif', '.bmp', '.json'],
  },
  svg: { description: 'SVG drawings', mimeTypes: ['image/svg+xml'], extensions: ['.svg'] },
  png: { description: 'PNG pictures', mimeTypes: ['image/png'], extensions: ['.png'] },
  jpeg: { description: 'JPEG pictures', mimeTypes: ['image/jpeg'], extensions: ['.jpg', '.jpeg'] },
  webp: { description: 'WebP pictures', mimeTypes: ['image/webp'], extensions: ['.webp'] },
  gif: { description: 'GIF pictures', mimeTypes: ['image/gif'], extensions: ['.gif'] },
  webm: { description: 'WebM films', mimeTypes: ['video/webm'], extensions: ['.webm'] },
  mp4: { description: 'MP4 films', mimeTypes: ['video/mp4'], extensions: ['.mp4'] },
  rig: { description: 'c2warp rigs', mimeTypes: ['application/octet-stream'], extensions: ['.c2rig'] },
  glb: { description: 'glTF files', mimeTypes: ['model/gltf-binary'], extensions: ['.glb'] },
  exr: { description: 'OpenEXR pictures', mimeTypes: ['image/x-exr'], extensions: ['.exr'] },
  npy: { description: 'NumPy arrays', mimeTypes: ['application/octet-stream'], extensions: ['.npy'] },
  csv: { description: 'CSV tables', mimeTypes: ['text/csv'], extensions: ['.csv'] },
  zip: { description: 'Zip archives', mimeTypes: ['application/zip'], extensions: ['.zip'] },
};

type Kind = keyof typeof KINDS;
export type FilmKind = Extract<Kind, 'webm' | 'mp4' | 'gif' | 'png' | 'webp' | 'zip'>;

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

/** The part of the File System Access API that TypeScript does not know. */
interface Asking {
  showSaveFilePicker(options: {
    suggestedName: string;
    id: string;
    types: { description: string; accept: Record<string, string[]> }[];
  }): Promise<FileSystemFileHandle>;
}

/** Asks for a file that is written bit by bit. Returns null if the browser has only downloads. */
export async function pickTarget(
  fileName: string,
  kind: FilmKind,
): Promise<FileSystemFileHandle | null | 'cancelled'> {
  if (!supported) return null;
  const { description, mimeTypes, extensions } = KINDS[kind];
  const types = [{ description, accept: Object.fromEntries(mimeTypes.map((type) => [type, extensions])) }];
  const asking = globalThis as unknown as Asking;
  const picked = asking.showSaveFilePicker({ suggestedName: fileName, id: kind, types });
  return (await unlessCancelled(picked)) ?? 'cancelled';
}

/** Asks for a folder to write into. Returns null if the user cancels. */
export async function pickFolder(id: string): Promise<FileSystemDirectoryHandle | null> {
  const asking = globalThis as unknown as {
    showDirectoryPicker(options: { id: string; mode: 'readwrite' }): Promise<FileSystemDirectoryHandle>;
  };
  return (await unlessCancelled(asking.showDirectoryPicker({ id, mode: 'readwrite' }))) ?? null;
}

/** Writes files into a folder, over older ones of the same names. Returns the name of the folder. */
export async function writeFiles(
  folder: FileSystemDirectoryHandle,
  files: readonly { readonly name: string; readonly bytes: Uint8Array<ArrayBuffer> }[],
): Promise<string> {
  for (const { name, bytes } of files) {
    const writing = await (await folder.getFileHandle(name, { create: true })).createWritable();
    await writing.write(bytes);
    await writing.close();
  }
  return folder.name;
}

/** Removes the empty file that browsers create when the user names a new one, if nothing was written to it. */
export async function removeEmpty(
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
