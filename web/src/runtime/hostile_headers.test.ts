import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { among, randomOf } from '../editor/random';
import { readHeader } from '../io/formats/header';

const CORPUS = new URL('../../../tests/attacks/corpus/pictures/', import.meta.url);
const MUTATIONS = 50_000;

/** Changes some bytes, and cuts the end off or puts that of another file there. */
function mutated(files: readonly Uint8Array[], random: () => number): Uint8Array<ArrayBuffer> {
  const [file, other] = [among(files, random), among(files, random)];
  const [kept, from] = [Math.floor(random() * (file.length + 1)), Math.floor(random() * (other.length + 1))];
  const end = random() < 0.5 ? file.subarray(kept) : random() < 0.5 ? other.subarray(from) : [];
  const bytes = Uint8Array.from([...file.subarray(0, kept), ...end]);
  for (let changes = Math.floor(random() * 6); changes > 0; changes--) {
    const value = random() < 0.5 ? Math.floor(random() * 256) : among([0, 1, 0x7f, 0x80, 0xff], random);
    bytes[Math.floor(random() * bytes.length)] = value;
  }
  return bytes;
}

describe('readHeader', () => {
  it('reads any bytes without an error, and names only sizes of whole pixels', () => {
    const files = readdirSync(CORPUS)
      .sort()
      .map((name) => readFileSync(new URL(name, CORPUS)));
    const random = randomOf(41);
    for (let count = 0; count < MUTATIONS; count++) {
      const bytes = mutated(files, random);
      const { size } = readHeader(bytes.buffer);
      const sides = size ? [size.width, size.height] : [];
      if (!sides.every((side) => Number.isInteger(side) && side >= 0)) {
        expect.fail(`${count}: ${sides} of ${Buffer.from(bytes).toString('hex')}`);
      }
    }
  });
});
