/** Exports maps and weights. All but this file is loaded at the first one. */
import type { EditorEffect } from '../editor/effects';
import { mapExtension } from '../editor/map_choices';
import { saveFile } from '../io/files';
import type { ExportFollowing } from './exports';
import { notLoaded } from './lazy_view';
import type { Pictures } from './pictures';

type Order = Extract<EditorEffect, { readonly type: 'export-map' }>;

/** Returns the name of the file, or null if the person cancels. */
export const exportMap = (
  order: Order,
  pictures: Pictures,
  pixelated: boolean,
  following: ExportFollowing,
): Promise<string | null> =>
  saveFile(made(order, pictures, pixelated, following), order.name, mapExtension(order.file));

async function made(
  { project, moment, picture, file }: Order,
  pictures: Pictures,
  pixelated: boolean,
  { signal, onProgress }: ExportFollowing,
): Promise<Blob> {
  const { pixels } = pictures.opened(picture);
  const { solvedExport } = await import('../compute/exporting').catch((cause: unknown) => {
    throw notLoaded(cause);
  });
  const pose = { clip: moment?.clip.name ?? null, time: moment?.time ?? 0 };
  const order = { kind: 'map', file, picture: picture.name, pixelated, ...pose } as const;
  return new Blob([await solvedExport(order, project, pixels, signal, onProgress)]);
}
