/** Bytes as text: base64 with the standard alphabet and padding. This folder has no DOM, which has `btoa`. */

const ALPHABET = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
const LETTERS = Uint8Array.from(ALPHABET, (letter) => letter.charCodeAt(0));
const PADDING = '='.charCodeAt(0);
/** The six bits of each letter, by its code. */
const BITS = new Uint8Array(128);
LETTERS.forEach((letter, bits) => {
  BITS[letter] = bits;
});

/** So many letters become text at once: a call takes no more arguments. */
const PART = 8192;

export function toBase64(bytes: Uint8Array): string {
  const letters = new Uint8Array(4 * Math.ceil(bytes.length / 3)).fill(PADDING);
  for (let at = 0, to = 0; at < bytes.length; at += 3, to += 4) {
    const bits = ((bytes[at] ?? 0) << 16) | ((bytes[at + 1] ?? 0) << 8) | (bytes[at + 2] ?? 0);
    const count = Math.min(3, bytes.length - at) + 1;
    for (let k = 0; k < count; k++) letters[to + k] = LETTERS[(bits >> (18 - 6 * k)) & 63] ?? 0;
  }
  let text = '';
  for (let at = 0; at < letters.length; at += PART)
    text += String.fromCharCode(...letters.subarray(at, at + PART));
  return text;
}

/** The bytes of a text that the solver has accepted. */
export function fromBase64(text: string): Uint8Array {
  const letters = text.replace(/=+$/, '').length;
  const bytes = new Uint8Array(Math.floor((letters * 3) / 4));
  let bits = 0;
  for (let k = 0; k < letters; k++) {
    bits = ((bits << 6) | (BITS[text.charCodeAt(k)] ?? 0)) & 0xffff;
    const full = ((k + 1) * 6) % 8;
    // Each letter but the first of four ends a byte.
    if (k % 4 !== 0) bytes[Math.floor(((k + 1) * 6) / 8) - 1] = bits >> full;
  }
  return bytes;
}
