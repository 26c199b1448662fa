/** Makes the file of a bent drawing. All but this file is loaded at the first one. */

import type { EditorEffect } from '../editor/effects';
import { readBytes } from '../io/read';
import { say } from '../texts/wording';
import type { ExportFollowing } from './exports';
import { notLoaded } from './lazy_view';
import type { Pictures } from './pictures';

type Order = Extract<EditorEffect, { readonly type: 'export' }>;

/** @throws The reason of the signal; C2WarpError for a drawing that cannot be bent. */
export async function bentFile(
  { project, moment, picture, choices }: Order,
  pictures: Pictures,
  { signal, onProgress, onRemark }: ExportFollowing,
): Promise<Blob> {
  const { pixels } = pictures.opened(picture);
  const { sentence, solvedExport } = await import('../compute/exporting').catch((cause: unknown) => {
    throw notLoaded(cause);
  });
  const svg = new TextDecoder().decode(await readBytes(picture.file as Blob));
  const pose = { clip: moment?.clip.name ?? null, time: moment?.time ?? 0 };
  const order = { kind: 'drawing', svg, grow: choices.area === 'grown', ...pose } as const;
  const bent = await solvedExport(order, project, pixels, signal, onProgress);
  for (const remark of bent.remarks) onRemark(say('exporting.remark', sentence(remark)));
  return new Blob([bent.svg], { type: 'image/svg+xml' });
}
