/**
 * Starts the workers of the element, under Trusted Types and from another origin than the page's too.
 *
 * Browsers start workers from the page's own origin only, but a script of that origin may import any whose server
 * allows it (CORS). So a page may take the element from elsewhere, and a sandboxed frame, whose origin is unique, can
 * run it.
 */
import type { TrustedTypePolicy, TrustedTypesWindow } from 'trusted-types/lib';

/** Created at first use, so that a page that forbids it is told why. */
let policy: Pick<TrustedTypePolicy, 'createScriptURL'> | undefined;

/** Addresses of scripts of the page's origin, by what they import. */
const importing: Record<string, string> = {};

/** @throws Error where the page's policy forbids it. */
export function startWorker(address: string): Worker {
  const { href, origin: home } = new URL(address, document.baseURI);
  if (home === origin) return new Worker(trusted(href), { type: 'module' });
  importing[href] ??= URL.createObjectURL(new Blob([importer(href)], { type: 'text/javascript' }));
  return new Worker(trusted(importing[href]));
}

/**
 * Keeps the messages that come before the module listens. It is no module itself: a sandboxed frame in Chromium
 * starts none from a blob.
 */
const importer = (address: string) => `
  const early = [];
  onmessage = (event) => early.push(event);
  import(${JSON.stringify(address)}).then(() => early.forEach((event) => onmessage(event)), reportError);
`;

function trusted(address: string): string {
  const { trustedTypes } = window as Partial<TrustedTypesWindow>;
  policy ??= trustedTypes?.createPolicy('c2warp', { createScriptURL: (own) => own });
  return (policy?.createScriptURL(address) ?? address) as string;
}
