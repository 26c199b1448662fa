/**
 * Poses with the solver, in a WebAssembly module that is loaded for the first rig that needs it. It is a separate
 * script without imports from the player.
 */
import init, { SectionPoser } from './generated/pose';

const MODULE = new URL('./generated/pose_bg.wasm', import.meta.url);

/** The motions of all sites for poses in one flat array, seven numbers per site. @throws Error */
export type ModulePoser = (poses: Float64Array) => Float64Array;

let starting: Promise<unknown> | undefined;

/** @throws Error with a sentence if the module cannot be loaded, or cannot read the section. */
export async function modulePoser(section: Uint8Array): Promise<ModulePoser> {
  starting ??= start();
  // A later call tries again: the network may be back.
  starting.catch(() => {
    starting = undefined;
  });
  await starting;
  const poser = new SectionPoser(section);
  return (poses) => poser.motions(poses);
}

async function start(): Promise<unknown> {
  const response = await fetch(MODULE);
  if (!response.ok) throw new Error(`the server answered ${response.status} for ${MODULE.href}`);
  return init({ module_or_path: response });
}
