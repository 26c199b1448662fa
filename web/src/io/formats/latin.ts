/** Text in binary files. */

/** Decodes up to `length` bytes as Latin-1; fewer at the end of the file. */
export function latin(view: DataView, at: number, length: number): string {
  const end = Math.min(at + length, view.byteLength);
  return at < end ? String.fromCharCode(...new Uint8Array(view.buffer, view.byteOffset + at, end - at)) : '';
}

export const startsWith = (view: DataView, text: string, at = 0): boolean =>
  latin(view, at, text.length) === text;
