/** Loads files by URL. */
import { type C2WarpError, codeOf } from '../error';
import { say } from '../texts/wording';
import { addressError } from './picture_error';

/** Returns the last part of a URL or path; `picture.png` for `data:` and `blob:` URLs, which have no name. */
export function fileName(address: string): string {
  if (/^\s*(data|blob):/i.test(address)) return 'picture.png';
  const name = address.split(/[?#]/)[0]?.split('/').at(-1) ?? '';
  try {
    return decodeURIComponent(name) || 'picture';
  } catch {
    // A stray percent sign.
    return name;
  }
}

export interface FetchOptions {
  readonly signal: AbortSignal;
  /** Whether a request to another origin carries cookies. */
  readonly credentials: RequestCredentials;
}

/**
 * Returns the file at a URL. A `data:` URL is decoded without a request, which a page's policy could forbid.
 *
 * @throws C2WarpError if the file cannot be loaded; AbortError if the signal is aborted.
 */
export async function fetchFile(address: string, options: FetchOptions): Promise<Blob> {
  if (/^\s*data:/i.test(address)) return dataFile(address);
  try {
    const response = await fetch(address, options);
    if (!response.ok)
      throw addressError('address', say('errors.address.status', fileName(address), response.status));
    if (/^text\/html\b/i.test(response.headers.get('Content-Type') ?? '')) {
      throw addressError('address', say('errors.address.webPage', fileName(address)));
    }
    return await response.blob();
  } catch (cause) {
    if (codeOf(cause) === 'address' || options.signal.aborted) throw cause;
    throw unreachable(address, cause);
  }
}

/** Browsers do not let a page distinguish a server that denies access from an unreachable one. */
function unreachable(address: string, cause: unknown): C2WarpError {
  const [, host = null] = /^\s*https?:\/\/([^/?#]+)/i.exec(address) ?? [];
  const file = fileName(address);
  const isOther = host !== null && host !== globalThis.location?.host;
  const wording = isOther
    ? say('errors.address.refused', file, host)
    : say('errors.address.unreachable', file);
  return addressError('address', wording, { cause });
}

/** Decodes a `data:` URL (RFC 2397). @throws C2WarpError if it is damaged. */
export function dataFile(address: string): Blob {
  const [, type = '', base64, content = ''] =
    /^\s*data:([^,;]*)(?:;[^,;]*?)*?(;base64)?,(.*)$/is.exec(address) ?? [];
  try {
    const bytes = base64
      ? Uint8Array.from(atob(decodeURIComponent(content)), (character) => character.charCodeAt(0))
      : new TextEncoder().encode(decodeURIComponent(content));
    return new Blob([bytes], { type });
  } catch (cause) {
    throw addressError('address', say('errors.address.damaged'), { cause });
  }
}
