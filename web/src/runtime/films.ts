/** Exports clips as films. All but this file is loaded when it is first needed. */
import type { EditorEffect } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import { asError } from '../error';
import type { ExportFollowing } from './exports';
import { notLoaded } from './lazy_view';
import type { Solver } from './solver';

type Effect<T extends EditorEffect['type']> = Extract<EditorEffect, { readonly type: T }>;

const load = () =>
  import('./filming').catch((cause: unknown) => {
    throw notLoaded(cause);
  });

export async function exportFilm(
  order: Effect<'export-film'>,
  solver: Solver,
  pixelated: boolean,
  following: ExportFollowing,
): Promise<string | null> {
  const { exportedFilm } = await load();
  return exportedFilm(solver, order, pixelated, following);
}

export async function findCodecs(
  { width, height, rate }: Effect<'find-codecs'>,
  dispatch: Dispatch,
): Promise<void> {
  try {
    const { videoCodecs } = await load();
    dispatch({ type: 'codecs-found', codecs: await videoCodecs({ width, height, rate }) });
  } catch (error) {
    dispatch({ type: 'error-reported', error: asError(error) });
  }
}
