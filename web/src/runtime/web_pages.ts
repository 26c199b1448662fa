/** Exports rigs for web pages, and copies the code that shows them. */
import type { EditorEffect } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import { saveFile } from '../io/files';
import type { ExportFollowing } from './exports';
import { notLoaded } from './lazy_view';
import type { Pictures } from './pictures';

type Order = Extract<EditorEffect, { readonly type: 'export-rig' }>;

export const exportRig = (
  order: Order,
  pictures: Pictures,
  following: ExportFollowing,
): Promise<string | null> => saveFile(rig(order, pictures, following), order.name, 'rig');

async function rig(
  { project, picture, posable }: Order,
  pictures: Pictures,
  { signal, onProgress }: ExportFollowing,
): Promise<Blob> {
  const { pixels } = pictures.opened(picture);
  const { rigFile } = await import('./rig_file').catch((cause: unknown) => {
    throw notLoaded(cause);
  });
  return rigFile(project, { file: picture.file as Blob, pixels }, posable, signal, onProgress);
}

/** Where the clipboard is blocked, the person can copy the code by hand. */
export async function copyCode(code: string, dispatch: Dispatch): Promise<void> {
  const copied = await navigator.clipboard.writeText(code).then(
    () => true,
    () => false,
  );
  dispatch({ type: 'code-copied', copied });
}
