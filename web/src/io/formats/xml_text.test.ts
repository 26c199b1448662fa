import { describe, expect, it } from 'vitest';
import { xmlText } from './xml_text';

const utf16 = (text: string, littleEndian: boolean): Uint8Array<ArrayBuffer> => {
  const view = new DataView(new ArrayBuffer(2 * text.length));
  [...text].forEach((character, at) => {
    view.setUint16(2 * at, character.charCodeAt(0), littleEndian);
  });
  return new Uint8Array(view.buffer);
};

const read = (bytes: Uint8Array<ArrayBuffer>) => xmlText(bytes.buffer);

/** A declaration, and bytes after it. */
const declared = (label: string, ...bytes: readonly number[]) => {
  const start = new TextEncoder().encode(`<?xml version='1.0' encoding = "${label}" ?>`);
  return read(new Uint8Array([...start, ...bytes]));
};

describe('xmlText', () => {
  it('reads texts in the encoding of their mark', () => {
    const drawing = '<svg id="Größe ☂"/>';
    const marked = `\ufeff${drawing}`;
    for (const bytes of [
      new TextEncoder().encode(drawing),
      new TextEncoder().encode(marked),
      utf16(marked, true),
      utf16(marked, false),
      utf16(drawing, true),
      utf16(drawing, false),
    ])
      expect(read(bytes)).toEqual({ text: drawing });
  });

  it('reads texts in the encoding of their declaration, which it removes', () => {
    for (const [label, byte, character] of [
      ['ISO-8859-1', 0xf6, 'ö'],
      ['latin1', 0xe9, 'é'],
      ['windows-1252', 0xe9, 'é'],
      ['ISO-8859-2', 0xb1, 'ą'],
      ['iso-8859-15', 0xa4, '€'],
      ['KOI8-R', 0xc1, 'а'],
      ['macintosh', 0x9a, 'ö'],
      ['UTF-16', 0x6f, 'o'],
    ] as const)
      expect(declared(label, byte)).toEqual({ text: `<?xml version='1.0' ?>${character}` });
  });

  it('names the encoding that a text is not in', () => {
    expect(declared('UTF-8', 0xf6)).toEqual({ unreadableAs: 'UTF-8' });
    expect(declared('Klingon', 0x61)).toEqual({ unreadableAs: 'Klingon' });
  });
});
