/** The structure of GIF files (GIF89a, appendix A). */
import type { Structure } from './structure';

const IMAGE = 0x2c;
const EXTENSION = 0x21;

export function gifHeader(view: DataView): Structure {
  if (view.byteLength < 13) return { size: undefined, end: 'missing', moves: false };
  const size = { width: view.getUint16(6, true), height: view.getUint16(8, true) };
  return { size, end: 'found', moves: framesUpTo2(view) > 1 };
}

/** Counts the frames of a GIF, but stops at the second. */
function framesUpTo2(view: DataView): number {
  let [at, frames] = [13 + colourTable(view.getUint8(10)), 0];
  while (at + 10 < view.byteLength && frames < 2) {
    const block = view.getUint8(at);
    if (block === IMAGE) {
      frames++;
      at = afterBlocks(view, at + 11 + colourTable(view.getUint8(at + 9)));
    } else if (block === EXTENSION) at = afterBlocks(view, at + 2);
    else break;
  }
  return frames;
}

/** The bytes of the colour table that the flags announce. */
const colourTable = (flags: number): number => (flags & 0x80 ? 3 << ((flags & 7) + 1) : 0);

/** Skips sub-blocks, each with its length, up to an empty one. */
function afterBlocks(view: DataView, from: number): number {
  let at = from;
  while (at < view.byteLength) {
    const length = view.getUint8(at);
    at += 1 + length;
    if (length === 0) break;
  }
  return at;
}
