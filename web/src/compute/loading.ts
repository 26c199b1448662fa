/** The file of the solver's module. */
import { C2WarpError, ENGINE } from '../error';

export const SOLVER = new URL('./generated/c2warp_bg.wasm', import.meta.url);

let loading: Promise<WebAssembly.Module> | undefined;

/** Fetches and compiles the solver once; later calls return the same module. @throws C2WarpError */
export function loadedModule(): Promise<WebAssembly.Module> {
  loading ??= compiled(SOLVER).catch((error: unknown) => {
    // A later call tries again: the network may be back.
    loading = undefined;
    throw notLoaded(error);
  });
  return loading;
}

/** @throws Error that names the address and the fault of the file. */
export async function compiled(url: URL): Promise<WebAssembly.Module> {
  try {
    return await fetched(url);
  } catch (cause) {
    throw new Error(`${url.href} ${reason(cause)}`, { cause });
  }
}

async function fetched(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`answers ${response.status}`);
  const type = response.headers.get('content-type') ?? '';
  // What development servers answer for a file that they do not have.
  if (type.startsWith('text/html')) throw new Error('is not there: a page is, in its place');
  // Streaming requires this very type, which not every server sends.
  if (type === 'application/wasm') return await WebAssembly.compileStreaming(response);
  return await WebAssembly.compile(await response.arrayBuffer());
}

/** The error of a solver that does not load. */
export const notLoaded = (cause: unknown): C2WarpError =>
  new C2WarpError(ENGINE, `The solver could not be loaded: ${words(cause)}`, { cause });

/** Browsers throw a TypeError where nothing comes, and a CompileError also for a file that is cut off. */
function reason(error: unknown): string {
  if (error instanceof TypeError) return 'does not come: is the network there, and does the page allow it?';
  if (error instanceof WebAssembly.CompileError)
    return `came incomplete, or cannot run here (${error.message}).`;
  return words(error);
}

const words = (error: unknown): string => (error instanceof Error ? error.message : String(error));
