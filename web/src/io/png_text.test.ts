import { decode } from 'fast-png';
import { describe, expect, it } from 'vitest';
import type { PngChunk } from './encoding';
import { crc32 } from './png_chunk';
import { textChunk, textIn, textOfFile } from './png_text';
import { PngFile } from './worker/png_file';

const TEXT = '{"name": "Katze – 猫"}';

async function written(chunks: readonly PngChunk[]): Promise<Uint8Array<ArrayBuffer>> {
  const settings = { width: 2, height: 1, quality: 1, background: '#ffffff' };
  const file = new PngFile({ type: 'image/png', ...settings, chunks });
  await file.write(Uint8Array.of(1, 2, 3, 255, 5, 6, 7, 255));
  return new Uint8Array(await (await file.finish()).arrayBuffer());
}

const bytes = (text = TEXT) => written([textChunk('c2warp', text)]);
/** Where the content of the chunk begins. */
const CONTENT = 8 + 25 + 8;

describe('a text in a PNG', () => {
  it('is read as written, without changing the pixels', async () => {
    const file = await bytes();
    expect(textIn(file.buffer, 'c2warp')).toBe(TEXT);
    expect(Array.from(decode(file).data)).toEqual([1, 2, 3, 255, 5, 6, 7, 255]);
  });

  it('is null without the keyword, in other files and in short ones', async () => {
    const file = await bytes();
    expect(textIn(file.buffer, 'c2')).toBeNull();
    expect(textIn((await written([])).buffer, 'c2warp')).toBeNull();
    expect(textIn(new TextEncoder().encode(TEXT).buffer, 'c2warp')).toBeNull();
    for (let length = 0; length < CONTENT + 20; length++) {
      expect(textIn(file.slice(0, length).buffer, 'c2warp')).toBeNull();
    }
  });

  it('is found in a file, and not sought in files of other types', async () => {
    expect(await textOfFile(new Blob([await bytes()]), 'c2warp')).toBe(TEXT);
    expect(await textOfFile(new Blob([TEXT]), 'c2warp')).toBeNull();
    expect(await textOfFile(new Blob(), 'c2warp')).toBeNull();
  });

  it('is refused if it is damaged', async () => {
    const file = await bytes();
    for (let at = CONTENT + 7; at < CONTENT + 7 + TEXT.length; at++) {
      const damaged = file.slice();
      damaged[at] = (damaged[at] ?? 0) ^ 16;
      expect(() => textIn(damaged.buffer, 'c2warp')).toThrow('The project in this picture is damaged');
    }
  });

  it('is refused if it is compressed, or no UTF-8', async () => {
    const changed = async (at: number, value: number) => {
      const file = await bytes('text');
      file[CONTENT + at] = value;
      const end = CONTENT + 'c2warp'.length + 5 + 'text'.length;
      new DataView(file.buffer).setUint32(end, crc32(file.subarray(CONTENT - 4, end)));
      return file.buffer;
    };
    const [compressed, broken] = [await changed(7, 1), await changed(12, 0xff)];
    expect(() => textIn(compressed, 'c2warp')).toThrow('is compressed');
    expect(() => textIn(broken, 'c2warp')).toThrow('is damaged');
  });

  it('has the checksum of the standard', () => {
    expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf43926);
  });
});
