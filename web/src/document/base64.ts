/** Bytes as text: base64 with the standard alphabet and padding. This folder has no DOM, which has `btoa`. */

const ALPHABET = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';

export function toBase64(bytes: Uint8Array): string {
  let text = '';
  for (let at = 0; at < bytes.length; at += 3) {
    const [a = 0, b = 0, c = 0] = bytes.subarray(at, at + 3);
    const bits = (a << 16) | (b << 8) | c;
    const letters = Math.min(3, bytes.length - at) + 1;
    for (let k = 0; k < 4; k++) text += k < letters ? ALPHABET[(bits >> (18 - 6 * k)) & 63] : '=';
  }
  return text;
}

/** The bytes of a text that the solver has accepted. */
export function fromBase64(text: string): Uint8Array {
  const letters = text.replace(/=+$/, '');
  const bytes = new Uint8Array(Math.floor((letters.length * 3) / 4));
  let bits = 0;
  for (let k = 0; k < letters.length; k++) {
    bits = ((bits << 6) | ALPHABET.indexOf(letters[k] ?? 'A')) & 0xffff;
    const full = ((k + 1) * 6) % 8;
    // Each letter but the first of four ends a byte.
    if (k % 4 !== 0) bytes[Math.floor(((k + 1) * 6) / 8) - 1] = bits >> full;
  }
  return bytes;
}
