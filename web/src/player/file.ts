/** The file of a rig: header, checksum and sections. */
import { C2WarpError } from '../error';

export interface Section {
  readonly tag: string;
  readonly data: Uint8Array<ArrayBuffer>;
}

const MAGIC = [0x89, 0x43, 0x32, 0x52, 0x49, 0x47, 0x0d, 0x0a];
const HEADER = 24;
const ROW = 12;
/** The checksum covers all bytes from here. */
const CHECKED = 20;
/** Versions of the format. The latest version displaces the picture before sites move it. */
const VERSIONS: readonly number[] = [1, 2];
/** Maximum length of all deflated sections, in bytes. */
const MOST_INFLATED = 512 * 2 ** 20;
/** Greatest compression ratio of deflate. */
const MOST_UNPACKED = 1032;

const CRCS = Uint32Array.from({ length: 256 }, (_, crc) => {
  for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

function crc32(data: Uint8Array): number {
  let crc = -1;
  for (const byte of data) crc = (CRCS[(crc ^ byte) & 255] ?? 0) ^ (crc >>> 8);
  return ~crc >>> 0;
}

/**
 * Returns the unpacked sections in file order, and whether the rig displaces its picture.
 *
 * @throws C2WarpError with a sentence for people if the bytes are not a rig, are damaged, or have an unknown version.
 */
export async function sectionsOf(
  file: Uint8Array<ArrayBuffer>,
): Promise<{ readonly sections: readonly Section[]; readonly isDisplaced: boolean }> {
  if (MAGIC.some((byte, at) => file[at] !== byte)) throw new C2WarpError('rig', 'This is not a rig.');
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const word = (at: number) => (at + 4 <= file.length ? view.getUint32(at, true) : Number.NaN);
  const check = (isRight: boolean, reason: string) => {
    if (!isRight) throw new C2WarpError('rig', `This rig is damaged: ${reason}.`);
  };
  const [version, length, checksum, count] = [8, 12, 16, 20].map(word) as [number, number, number, number];
  check(file.length >= HEADER, 'it is truncated');
  if (!VERSIONS.includes(version))
    throw new C2WarpError(
      'rig',
      `This rig has version ${version} of the format. The player reads versions 1 and 2.`,
    );
  check(length === file.length, `it has ${file.length} bytes instead of ${length}`);
  check(checksum === crc32(file.subarray(CHECKED)), 'its checksum does not match');
  check(count <= (length - HEADER) / ROW, 'its table is longer than the file');
  let at = HEADER + ROW * count;
  const rows = Array.from({ length: count }, (_, row) => {
    const start = HEADER + ROW * row;
    const stored = file.subarray(at, at + word(start + 4));
    at += word(start + 4);
    const tag = String.fromCharCode(...file.subarray(start, start + 4));
    return { tag, stored, length: word(start + 8) };
  });
  check(at === length, 'its sections do not add up to its length');
  const inflated = rows.filter(({ stored, length }) => stored.length !== length);
  check(sum(inflated) <= MOST_INFLATED, 'its sections are longer than 512 MiB');
  const sections = await Promise.all(
    rows.map(async ({ tag, stored, length }) => ({ tag, data: await unpacked(stored, length) })),
  );
  return { sections, isDisplaced: version === 2 };
}

const sum = (rows: readonly { readonly length: number }[]): number =>
  rows.reduce((sum, { length }) => sum + length, 0);

async function unpacked(stored: Uint8Array<ArrayBuffer>, length: number): Promise<Uint8Array<ArrayBuffer>> {
  if (length === stored.length) return stored;
  try {
    if (length > stored.length * MOST_UNPACKED) throw new RangeError();
    const data = new Uint8Array(length);
    let at = 0;
    const stream = new Blob([stored]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    const reader = stream.getReader();
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      // Too many bytes do not fit.
      data.set(value, at);
      at += value.length;
    }
    if (at < length) throw new RangeError();
    return data;
  } catch {
    throw new C2WarpError('rig', 'This rig is damaged: a section cannot be unpacked.');
  }
}
