/** Makes the file of a rig. Loaded at first use. */
import { solvedExport } from '../compute/exporting';
import type { Project } from '../document/project';
import type { PixelSource } from '../io/open_picture';
import { rigPicture } from './rig_picture';

/** @throws The reason of the signal; Error with a sentence for people. */
export async function rigFile(
  project: Project,
  picture: { readonly file: Blob; readonly pixels: PixelSource },
  posable: boolean,
  signal: AbortSignal,
  onProgress: (fraction: number) => void,
): Promise<Blob> {
  const file = await rigPicture(picture.file, picture.pixels, signal);
  return new Blob([
    await solvedExport({ kind: 'web-rig', file, posable }, project, picture.pixels, signal, onProgress),
  ]);
}
