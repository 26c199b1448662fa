/** A project as the hash of an address: its JSON, deflated, in the alphabet of base64url. */

/** The most characters of a hash, and the most bytes of the JSON in it. Longer ones are refused unread. */
export const MOST = { characters: 32_000, bytes: 400_000 };

const PREFIX = '#rig=';

/** Why an address holds no rig; the message is for people. */
export class SharedRigError extends Error {}

/** The hash for a project. @throws SharedRigError if the address would be too long. */
export async function hashOf(project: unknown): Promise<string> {
  const json = new Blob([JSON.stringify(project)]);
  const packed = json.stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  const hash = `${PREFIX}${base64url(bytes)}`;
  if (hash.length > MOST.characters)
    throw new SharedRigError('This project is too large for a link. Copy its JSON instead.');
  return hash;
}

/** The project in a hash, or undefined if the hash is of another kind. @throws SharedRigError */
export async function projectIn(hash: string): Promise<unknown> {
  if (!hash.startsWith(PREFIX)) return undefined;
  if (hash.length > MOST.characters)
    throw new SharedRigError('This link is too long to be a rig. The sample is shown instead.');
  try {
    return JSON.parse(await inflated(bytesOf(hash.slice(PREFIX.length))));
  } catch (error) {
    if (error instanceof SharedRigError) throw error;
    throw new SharedRigError(
      'This link is damaged: a part of it is missing or changed. The sample is shown instead.',
    );
  }
}

async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const reader = plain.pipeThrough(new TextDecoderStream('utf-8', { fatal: true })).getReader();
  let text = '';
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    text += part.value;
    if (text.length <= MOST.bytes) continue;
    await reader.cancel();
    throw new SharedRigError('The rig in this link is too large. The sample is shown instead.');
  }
  return text;
}

const base64url = (bytes: Uint8Array): string =>
  btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replaceAll('=', '');

const bytesOf = (text: string): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (character) =>
    character.charCodeAt(0),
  );
