/** The solver's module, compiled once for all editors of a page. The only page file that imports the generated code. */

import type { Clip, Handle, Project } from '../document/project';
import { ENGINE, WarpError } from '../error';
import init, {
  frame_times,
  ClipPoses as ModuleClip,
  PosedPicture as ModulePicture,
  ClipPlayback as ModulePlayback,
  project_check,
} from './generated/c2warp';
import type { SolutionData } from './solution';

export type { ModuleClip, ModulePicture, ModulePlayback };

let loading: Promise<WebAssembly.Module> | undefined;

/** Fetches, compiles and instantiates the module once; later calls return the same one. */
export function loadModule(): Promise<WebAssembly.Module> {
  loading ??= load().catch((error: unknown) => {
    // A later call tries again: the network may be back.
    loading = undefined;
    throw new WarpError(ENGINE, `The solver could not be loaded: ${reason(error)}`, { cause: error });
  });
  return loading;
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
 * A project file's project, with every key written out. Requires the module to be loaded.
 * @throws Error with a code and a message that names the offending key.
 */
export function checkedProject(text: string): Project {
  return JSON.parse(project_check(text)) as Project;
}

/** Browsers throw a TypeError where nothing comes, and a CompileError also for a file that is cut off. */
function reason(error: unknown): string {
  if (error instanceof TypeError) return 'is the network there, and does the page allow it?';
  if (error instanceof WebAssembly.CompileError)
    return `it came incomplete, or cannot run here (${error.message}).`;
  return error instanceof Error ? error.message : String(error);
}

async function load(): Promise<WebAssembly.Module> {
  const module = await compiled(new URL('./generated/c2warp_bg.wasm', import.meta.url));
  await init({ module_or_path: module });
  return module;
}

/** @throws Error that says what is wrong with the file. */
export async function compiled(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname} answers ${response.status}`);
  const type = response.headers.get('content-type') ?? '';
  // What development servers answer for a file that they do not have.
  if (type.startsWith('text/html')) throw new Error(`${url.pathname} is not there: a page is, in its place`);
  // Streaming requires this very type, which not every server sends.
  if (type === 'application/wasm') return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}
