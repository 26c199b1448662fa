/**
 * The files of one version, stored by path and content.
 *
 * Versions share the files that they have in common, so that an update loads only changed files. A download that is
 * interrupted is resumed.
 */

/** The hash of each file's content by its path, in the form of Subresource Integrity. The page has the path "". */
export type FileHashes = Readonly<Record<string, string>>;

/** Before the second and the third try of a download. */
const PAUSES_MS = [1000, 4000];

/** The storage key of a file: the query distinguishes contents. */
const addressOf = (scope: string, path: string, hash: string): string =>
  new URL(`./${path}?${encodeURIComponent(hash)}`, scope).href;

/**
 * Downloads the files that are not stored yet.
 *
 * @throws TypeError if a file cannot be loaded, or has another content. Others stay for the next attempt.
 */
export async function storeFiles(
  cache: Cache,
  scope: string,
  hashes: FileHashes,
  pausesMs = PAUSES_MS,
): Promise<void> {
  const stored = await Promise.allSettled(
    Object.entries(hashes).map(async ([path, hash]) => {
      const address = addressOf(scope, path, hash);
      if (await cache.match(address, { ignoreVary: true })) return;
      await cache.put(address, await downloaded(new URL(`./${path}`, scope).href, hash, pausesMs));
    }),
  );
  for (const result of stored) if (result.status === 'rejected') throw result.reason;
}

async function downloaded(
  address: string,
  integrity: string,
  pausesMs: readonly number[],
): Promise<Response> {
  // The browser's cache may answer at first: a stale answer has another hash, and is refused.
  let cache: RequestCache = 'default';
  for (const pause of [...pausesMs, null]) {
    try {
      const response = await fetch(address, { integrity, cache });
      if (!response.ok) throw new TypeError(`${address}: the server answered ${response.status}`);
      return response.redirected ? direct(response) : response;
    } catch (error) {
      if (pause === null) throw error;
      cache = 'reload';
      await new Promise((done) => setTimeout(done, pause));
    }
  }
  throw new TypeError(`${address}: not loaded`);
}

/** Browsers take no redirected answer for a page. */
const direct = ({ body, headers }: Response): Response => new Response(body, { headers });

/** Removes the files of other versions. */
export async function removeOthers(cache: Cache, scope: string, hashes: FileHashes): Promise<void> {
  const kept = new Set(Object.entries(hashes).map(([path, hash]) => addressOf(scope, path, hash)));
  for (const request of await cache.keys()) if (!kept.has(request.url)) await cache.delete(request);
}

/** The path of an address among the files; null if no file matches. */
export function pathOf(scope: string, address: string, hashes: FileHashes): string | null {
  const { origin, pathname } = new URL(address);
  const folder = new URL(scope);
  if (origin !== folder.origin || !pathname.startsWith(folder.pathname)) return null;
  const path = pathname.slice(folder.pathname.length).replace(/^index\.html$/, '');
  return Object.hasOwn(hashes, path) ? path : null;
}

/** A stored file; undefined if the browser has removed it. */
export const storedFile = (
  cache: Cache,
  scope: string,
  path: string,
  hashes: FileHashes,
): Promise<Response | undefined> =>
  cache.match(addressOf(scope, path, hashes[path] ?? ''), { ignoreVary: true });
