/** The solver's module in the page: compiled once, whatever the number of editors. Alone here in importing the glue. */

import { ENGINE, EngineError } from './errors';
import init, { Poser as GeneratedPoser, project_check } from './generated/c2warp';

/** Turns posed handles into the motions of all sites, in microseconds. */
export interface Poser {
  /**
   * @param handles The project's handles as JSON.
   * @returns Sites × 12: a, b, c, d, rest x, rest y, posed x, posed y, depth, angle, cosine and sine of half of it.
   */
  pose(handles: string): Float32Array<ArrayBuffer>;
  free(): void;
}

let loading: Promise<WebAssembly.Module> | undefined;

/** Fetches, compiles and instantiates the module, the first time; later calls get the same. */
export function loadModule(): Promise<WebAssembly.Module> {
  loading ??= load().catch((error: unknown) => {
    // A network may come back.
    loading = undefined;
    throw new EngineError(
      { code: ENGINE, message: `The solver could not be loaded: ${error}` },
      { cause: error },
    );
  });
  return loading;
}

/** To be called once the module is loaded. */
export function createPoser(bytes: Uint8Array): Poser {
  return new GeneratedPoser(bytes);
}

/** The project file with every key written out. To be called once the module is loaded. */
export function checkedProject(text: string): string {
  return project_check(text);
}

async function load(): Promise<WebAssembly.Module> {
  const module = await compile(new URL('./generated/c2warp_bg.wasm', import.meta.url));
  await init({ module_or_path: module });
  return module;
}

async function compile(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname} answers ${response.status}`);
  // Streaming wants this type, which not every static server knows.
  if (response.headers.get('content-type')?.startsWith('application/wasm')) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}
