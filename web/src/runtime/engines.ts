/** Exports rigs for game engines. All but this file is loaded at the first one. */
import type { EditorEffect } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import { pickFolder, saveFile, writeFiles } from '../io/files';
import type { ExportFollowing } from './exports';
import { notLoaded } from './lazy_view';
import type { Pictures } from './pictures';

type Order = Extract<EditorEffect, { readonly type: 'export-engine-rig' }>;

/** Returns the name of the file or folder, or null if the person cancels. */
export async function exportEngineRig(
  order: Order,
  pictures: Pictures,
  { signal, onProgress }: ExportFollowing,
  dispatch: Dispatch,
): Promise<string | null> {
  const { project, choices, picture, target } = order;
  const made = async () => {
    const { pixels } = pictures.opened(picture);
    const { solvedExport } = await import('../compute/exporting').catch((cause: unknown) => {
      throw notLoaded(cause);
    });
    const rig = { kind: 'engine-rig', ...order.order, zip: target === 'zip' ? order.name : null } as const;
    const { files, loss } = await solvedExport(rig, project, pixels, signal, onProgress);
    dispatch({ type: 'engine-rig-measured', project, choices, loss });
    return files;
  };
  if (target === 'folder') {
    // First of all: browsers ask only shortly after a click.
    const folder = await pickFolder('rig');
    return folder && writeFiles(folder, await made());
  }
  const blob = made().then(([file]) => new Blob(file ? [file.bytes] : []));
  return saveFile(blob, order.name, target === 'zip' ? 'zip' : 'glb');
}
