/** Loads files by URL. */
import { codeOf, WarpError } from '../error';

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

/**
 * Returns the file at a URL.
 *
 * @throws WarpError if the file cannot be loaded; AbortError if the signal is aborted.
 */
export async function fetchFile(address: string, signal: AbortSignal): Promise<Blob> {
  try {
    const response = await fetch(address, { signal });
    if (response.ok) return await response.blob();
    throw new WarpError(
      'address',
      `${fileName(address)} could not be loaded: the server answered ${response.status}.`,
    );
  } catch (cause) {
    if (codeOf(cause) === 'address' || signal.aborted) throw cause;
    throw new WarpError(
      'address',
      `${fileName(address)} could not be loaded. Check the address and the network connection.`,
      { cause },
    );
  }
}
