/**
 * The service worker of the editor's page: answers with stored files, so that the editor works without a network.
 *
 * A version is stored whole or not at all. A newer version is stored beside the running one and waits, so that all open
 * pages keep their version. It takes over when no page is left, or when the only page reloads and requests it.
 */
import { filesCache, sharedCache } from './cache_names';
import { keepShared, SHARED } from './shared_files';
import { type FileHashes, pathOf, removeOthers, storedFile, storeFiles } from './stored_files';

/** Filled in by the build: see `web/scripts/service_worker.mjs`. */
declare const FILE_HASHES: FileHashes;

const worker = self as unknown as ServiceWorkerGlobalScope;
const { scope } = worker.registration;
/** Once, since the build replaces its name with the list. */
const hashes = FILE_HASHES;

const files = (): Promise<Cache> => caches.open(filesCache(scope));

worker.addEventListener('install', (event) => {
  event.waitUntil(files().then((cache) => storeFiles(cache, scope, hashes)));
});

worker.addEventListener('activate', (event) => {
  event.waitUntil(
    files()
      .then((cache) => removeOthers(cache, scope, hashes))
      // The page of the first visit then needs no network either.
      .then(() => worker.clients.claim()),
  );
});

/** A page that has just started asks this version, which waits, to take over. */
worker.addEventListener('message', (event) => {
  event.waitUntil(
    isOnlyPage().then(async (isOnly) => {
      event.ports[0]?.postMessage(isOnly);
      if (isOnly) await worker.skipWaiting();
    }),
  );
});

worker.addEventListener('fetch', (event) => {
  const { method, url, mode } = event.request;
  const path = pathOf(scope, url, hashes);
  if (path === null) return;
  if (method === 'GET') event.respondWith(answer(path, event.request));
  else if (method === 'POST' && mode === 'navigate' && path === '')
    event.respondWith(received(event.request));
});

async function answer(path: string, request: Request): Promise<Response> {
  return (await storedFile(await files(), scope, path, hashes)) ?? fetch(request);
}

/**
 * Keeps shared files for the page, which opens next. If they cannot be stored, the page reports that no files arrived.
 */
async function received(request: Request): Promise<Response> {
  try {
    await keepShared(await caches.open(sharedCache(scope)), scope, await request.formData());
  } catch (error) {
    console.error(error);
  }
  return Response.redirect(`${scope}?${SHARED}`, 303);
}

/** Whether only one page shows the editor: those of the running version count too. */
async function isOnlyPage(): Promise<boolean> {
  const pages = await worker.clients.matchAll({ type: 'window', includeUncontrolled: true });
  return pages.filter(({ url }) => pathOf(scope, url, hashes) === '').length < 2;
}
