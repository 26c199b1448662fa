/**
 * Starts the workers of the element, also under Trusted Types and from another origin than the page's.
 *
 * Browsers start workers from the page's own origin only, but a script of that origin can import scripts of any server
 * that allows it (CORS). So pages can load the element from another origin. Sandboxed frames, whose origin is unique,
 * can run it too.
 */
import type { TrustedTypePolicy, TrustedTypesWindow } from 'trusted-types/lib';

/** By name. Created at first use, so that the error appears there if the page forbids the policy. */
const policies: Record<string, Pick<TrustedTypePolicy, 'createScriptURL'> | undefined> = {};

/** URLs of importing scripts of the page's origin, by the URL of the imported module. */
const importerUrls: Record<string, string> = {};

/**
 * Starts a module worker.
 *
 * @param policy The name of the policy for Trusted Types. Each script of a page needs its own.
 * @throws Error if the page's policy forbids it.
 */
export function startWorker(address: string, policy = 'c2warp'): Worker {
  const { href, origin: home } = new URL(address, document.baseURI);
  if (home === origin) return new Worker(trusted(href, policy), { type: 'module' });
  importerUrls[href] ??= URL.createObjectURL(new Blob([importer(href)], { type: 'text/javascript' }));
  return new Worker(trusted(importerUrls[href], policy));
}

/**
 * Returns a function that starts a worker unless it runs, for all editors of a page. After a failure, the next call
 * starts another.
 *
 * The function throws an Error if the page's policy forbids the worker.
 */
export function sharedWorker(address: string): () => Worker {
  let running: Worker | null = null;
  return () => {
    if (running) return running;
    const started = startWorker(address);
    started.addEventListener('error', () => {
      if (running === started) running = null;
      started.terminate();
    });
    running = started;
    return started;
  };
}

/**
 * Returns a script that imports a module, and queues messages until the module listens. The script is a classic one,
 * since sandboxed frames in Chromium start no modules from blobs.
 */
const importer = (address: string) => `
  const early = [];
  onmessage = (event) => early.push(event);
  import(${JSON.stringify(address)}).then(() => early.forEach((event) => onmessage(event)), reportError);
`;

/** An address of a worker, as Trusted Types want it. */
export function trusted(address: string, name: string): string {
  const { trustedTypes } = window as Partial<TrustedTypesWindow>;
  const policy = policies[name] ?? trustedTypes?.createPolicy(name, { createScriptURL: (own) => own });
  policies[name] = policy;
  return (policy?.createScriptURL(address) ?? address) as string;
}
