/** Files by their addresses. */

/** A file that cannot be loaded. The message can be shown to the person. */
export class AddressError extends Error {
  readonly code = 'address';

  constructor(message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = 'AddressError';
  }
}

/** The last part of an address or path. `data:` and `blob:` addresses hold no name: `picture.png` stands for it. */
export function fileName(address: string): string {
  if (/^\s*(data|blob):/i.test(address)) return 'picture.png';
  const written = address.split(/[?#]/)[0]?.split('/').at(-1) ?? '';
  try {
    return decodeURIComponent(written) || 'picture';
  } catch {
    // A percent sign that encodes no character.
    return written;
  }
}

/** @throws AddressError where the file cannot be loaded; AbortError where the signal is aborted. */
export async function fetchFile(address: string, signal: AbortSignal): Promise<Blob> {
  try {
    const response = await fetch(address, { signal });
    if (response.ok) return await response.blob();
    throw new AddressError(
      `${fileName(address)} could not be loaded: the server answered ${response.status}.`,
    );
  } catch (cause) {
    if (cause instanceof AddressError || signal.aborted) throw cause;
    throw new AddressError(
      `${fileName(address)} could not be loaded: is the address right, and the network there?`,
      { cause },
    );
  }
}
