/** Files that other programs share with the installed editor: the worker keeps them, and the page takes them. */

/** The field of the form, and the query of the page that takes the files. See `manifest.webmanifest`. */
const FIELD = 'files';
export const SHARED = 'shared';

/** Keeps the files of a form, and returns how many there are. */
export async function keepShared(cache: Cache, scope: string, form: FormData): Promise<number> {
  const files = form.getAll(FIELD).filter((entry) => entry instanceof File);
  await Promise.all(
    files.map((file, k) =>
      // A number each, since names can be alike.
      cache.put(`${scope}${SHARED}/${k}/${encodeURIComponent(file.name)}`, new Response(file)),
    ),
  );
  return files.length;
}

/** Takes the files out of the cache. */
export async function takeShared(cache: Cache): Promise<File[]> {
  const files = [];
  for (const request of await cache.keys()) {
    const response = await cache.match(request);
    await cache.delete(request);
    if (!response) continue;
    const name = decodeURIComponent(request.url.slice(request.url.lastIndexOf('/') + 1));
    const type = response.headers.get('Content-Type') ?? '';
    files.push(new File([await response.blob()], name, { type }));
  }
  return files;
}
