/**
 * Poses with the solver, in a WebAssembly module that is loaded for the first rig that needs it. It is a separate
 * script without imports from the player.
 */
import init, { SectionPoser } from './generated/pose';
import type { Mesh, Weights } from './mesh';

const MODULE = new URL('./generated/pose_bg.wasm', import.meta.url);

/**
 * The motions of all sites for poses in one flat array, seven numbers per site. With `before`, the motions continue
 * these, as the next frame of a drag, or where the drag rests.
 *
 * @throws Error
 */
export type ModulePoser = (poses: Float64Array, before?: Float64Array, rests?: boolean) => Float64Array;

let starting: Promise<unknown> | undefined;

/** @throws Error with a sentence if the module cannot be loaded, or cannot read the section. */
export async function modulePoser(
  section: Uint8Array,
  { positions, triangles, rows, entries }: Mesh & Weights,
): Promise<ModulePoser> {
  starting ??= start();
  // A later call tries again: the network may be back.
  starting.catch(() => {
    starting = undefined;
  });
  await starting;
  const poser = new SectionPoser(section, positions, triangles, rows, entries);
  return (poses, before, rests) => {
    if (!before) return poser.motions(poses);
    return rests ? poser.settled(before, poses) : poser.followed(before, poses);
  };
}

async function start(): Promise<unknown> {
  const response = await fetch(MODULE);
  if (!response.ok) throw new Error(`the server answered ${response.status} for ${MODULE.href}`);
  return init({ module_or_path: response });
}
