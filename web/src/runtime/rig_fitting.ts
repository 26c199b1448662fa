/** Fits the rig of one picture to another. The picture that it was made for is read again for its outline. */
import type { EditorEffect } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import { asError } from '../error';
import type { Pictures } from './pictures';
import type { Solver } from './solver';

type Order = Extract<EditorEffect, { readonly type: 'fit-rig' }>;

export async function fitRig(
  { rig, picture }: Order,
  pictures: Pictures,
  solver: Solver,
  dispatch: Dispatch,
): Promise<void> {
  // Without transparency there is no outline to align with.
  const outlined = picture.alphaThreshold === null ? null : rig.own;
  const own = outlined && pictures.read(outlined.file, outlined.name, new AbortController().signal);
  try {
    const pixels = own && pictures.opened(await own).pixels;
    const { project, moved } = await solver.fit(rig.project, pixels);
    dispatch({ type: 'rig-fitted', rig, picture, project, moved });
  } catch (error) {
    dispatch({ type: 'error-reported', error: asError(error) });
  } finally {
    own?.then(
      (read) => pictures.drop(read),
      () => {},
    );
  }
}
