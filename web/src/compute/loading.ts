/** The files of the solver's module: the part that all pages need, and the later one. */
import { asError, type C2WarpError, ENGINE, wordingOf } from '../error';
import { say, type Words } from '../texts/wording';
import { engineError } from './engine_error';

export const SOLVER = new URL('./generated/c2warp_bg.wasm', import.meta.url);

/** Suggestions, drawings, films, fills and explanations: see `wasm/xtask/src/bindgen.rs`. */
export const LATER = new URL('./generated/c2warp_later_bg.wasm', import.meta.url);

/** Returns a function that loads a module once. Later calls return the same one. */
export function once(load: () => Promise<WebAssembly.Module>): () => Promise<WebAssembly.Module> {
  let loading: Promise<WebAssembly.Module> | undefined;
  return () => {
    loading ??= load().catch((error: unknown) => {
      // A later call tries again: the network may be back.
      loading = undefined;
      throw notLoaded(error);
    });
    return loading;
  };
}

/** Fetches and compiles the solver. @throws C2WarpError */
export const loadedModule = once(() => compiled(SOLVER));

/** Fetches and compiles the later part of the solver. @throws C2WarpError */
export const loadedLater = once(() => compiled(LATER));

/** @throws C2WarpError that names the address and the fault of the file. */
export async function compiled(url: URL): Promise<WebAssembly.Module> {
  try {
    return await fetched(url);
  } catch (cause) {
    throw wordingOf(cause) ? cause : fileError(url, cause);
  }
}

async function fetched(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw engineError(ENGINE, say('errors.engine.status', url.href, response.status));
  const type = response.headers.get('content-type') ?? '';
  // What development servers answer for a file that they do not have.
  if (type.startsWith('text/html')) throw engineError(ENGINE, say('errors.engine.isPage', url.href));
  // Streaming requires this very type, which not every server sends.
  if (type === 'application/wasm') return await WebAssembly.compileStreaming(response);
  return await WebAssembly.compile(await response.arrayBuffer());
}

/** The error of a solver that does not load. */
export const notLoaded = (cause: unknown): C2WarpError =>
  engineError(ENGINE, say('errors.engine.notLoaded', whyOf(cause)), { cause });

/** The text of an error, or its message. */
export const whyOf = (error: unknown): Words => wordingOf(error) ?? asError(error).message;

/** Browsers throw a TypeError where nothing comes, and a CompileError also for a file that is cut off. */
function fileError(url: URL, cause: unknown): Error {
  if (cause instanceof TypeError)
    return engineError(ENGINE, say('errors.engine.absent', url.href), { cause });
  if (cause instanceof WebAssembly.CompileError)
    return engineError(ENGINE, say('errors.engine.incomplete', url.href, cause.message), { cause });
  return new Error(`${url.href} ${asError(cause).message}`, { cause });
}
