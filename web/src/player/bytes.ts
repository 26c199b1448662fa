/** Numbers in the sections of a rig: see web/docs/rig-format.md. */
import { C2WarpError } from '../error';

/** Reads a section from its beginning. Every method throws a `C2WarpError` if the section breaks the format. */
export interface Bytes {
  byte(): number;
  varint(): number;
  signed(): number;
  /** Reads a number of items of at least `bytes` bytes each, and checks that the section is long enough. */
  count(bytes?: number): number;
  float(): number;
  text(): string;
  /** Checks that nothing follows. */
  end(): void;
  check(isRight: boolean, reason: string): void;
  /** Whether this many bytes may follow. */
  has(count: number): boolean;
}

/** @param part the name of the section in errors. */
export function bytesOf(part: string, data: Uint8Array): Bytes {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  let at = 0;
  const wrong = (reason: string) => new C2WarpError('rig', `This rig is damaged: ${part} ${reason}.`);
  const check = (isRight: boolean, reason: string) => {
    if (!isRight) throw wrong(reason);
  };
  const take = (count: number) => {
    check(count <= data.length - at, 'ends too early');
    at += count;
    return at - count;
  };
  const byte = () => view.getUint8(take(1));
  const varint = () => {
    let number = 0;
    for (let place = 1; place < 2 ** 35; place *= 128) {
      const digit = byte();
      number += (digit & 127) * place;
      if (digit > 127) continue;
      check(number < 2 ** 32, 'contains a number of more than 32 bits');
      return number;
    }
    throw wrong('contains a number of more than 32 bits');
  };
  const has = (count: number) => count <= data.length - at;
  const count = (bytes = 1) => {
    const number = varint();
    check(has(number * bytes), 'ends too early');
    return number;
  };
  return {
    byte,
    varint,
    signed() {
      const number = varint();
      return (number >>> 1) ^ -(number & 1);
    },
    count,
    float: () => view.getFloat64(take(8), true),
    text() {
      const length = count();
      const bytes = data.subarray(take(length), at);
      try {
        return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
      } catch {
        throw wrong('contains text that is not UTF-8');
      }
    },
    end: () => check(at === data.length, 'continues past its end'),
    check,
    has,
  };
}
