/** The solver's module, compiled once for all editors of a page. The only page file that imports the generated code. */

import { type Clip, type Handle, type Project, type ProjectFile, posedHandle } from '../document/project';
import { C2WarpError } from '../error';
import init, {
  frame_times,
  ClipPoses as ModuleClip,
  PosedPicture as ModulePicture,
  ClipPlayback as ModulePlayback,
  project_check,
} from './generated/c2warp';
import { loadedModule, notLoaded } from './loading';
import type { SolutionData } from './solution';

export type { ModuleClip, ModulePicture, ModulePlayback };

let starting: Promise<WebAssembly.Module> | undefined;

/** Fetches, compiles and instantiates the module once; later calls return the same one. @throws C2WarpError */
export function loadModule(): Promise<WebAssembly.Module> {
  starting ??= start().catch((error: unknown) => {
    starting = undefined;
    throw error instanceof C2WarpError ? error : notLoaded(error);
  });
  return starting;
}

async function start(): Promise<WebAssembly.Module> {
  const module = await loadedModule();
  await init({ module_or_path: module });
  return module;
}

/** Requires the module to be loaded. @param handles The solved handles. */
export const createModulePicture = (data: SolutionData, handles: readonly Handle[]): ModulePicture =>
  new ModulePicture(data, data.report.samples, JSON.stringify(handles));

/**
 * Requires the module to be loaded.
 * @throws Error with a code and a message that names the offending key of the clip.
 */
export const createModuleClip = (clip: Clip, handles: readonly Handle[]): ModuleClip =>
  new ModuleClip(JSON.stringify(clip), JSON.stringify(handles));

/**
 * @param handles The solved handles, in their present poses.
 * @throws Error with a code and a message that names the offending key of the clip.
 */
export const createModulePlayback = (
  picture: ModulePicture,
  clip: Clip,
  handles: readonly Handle[],
): ModulePlayback => new ModulePlayback(picture, JSON.stringify(clip), JSON.stringify(handles));

/**
 * The times of a film's frames, in seconds. Requires the module to be loaded.
 * @throws Error with a code and a message about a rate, a part or a length that no film has.
 */
export const frameTimes = (
  clip: Clip,
  handles: readonly Handle[],
  rate: number,
  range: readonly [from: number, to: number] | null,
): Float64Array => frame_times(JSON.stringify(clip), JSON.stringify(handles), rate, range?.[0], range?.[1]);

/**
 * A project file's project, with its keys as they are written, and a pose for each handle. Requires the module to be
 * loaded.
 * @throws Error with a code and a message that names the offending key.
 */
export function checkedProject(text: string): Project {
  project_check(text);
  const project = JSON.parse(text) as ProjectFile;
  return { ...project, handles: project.handles.map(posedHandle) };
}
