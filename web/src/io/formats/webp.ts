/** The structure of WebP files: chunks of a RIFF container. */
import { orientationOf } from './exif';
import { latin } from './latin';
import type { Structure } from './structure';

interface Chunk {
  readonly name: string;
  /** The position of its contents. */
  readonly at: number;
  readonly size: number;
}

export function webpHeader(view: DataView): Structure {
  const end = view.getUint32(4, true) + 8 <= view.byteLength ? 'found' : 'missing';
  const frames = chunks(view).filter(({ name }) => name === 'ANMF').length;
  const orientation = chunks(view)
    .filter(({ name }) => name === 'EXIF')
    .map(({ at, size }) => orientationOf(new DataView(view.buffer, view.byteOffset + at, size)))[0];
  return { size: webpSize(view), end, moves: frames > 1, ...(orientation && { orientation }) };
}

/**
 * Returns the file without its EXIF data. Some browsers apply the orientation of a WebP and others ignore it: without
 * the data, all ignore it.
 */
export function withoutExif(file: ArrayBuffer): ArrayBuffer {
  const copy = file.slice(0);
  const bytes = new Uint8Array(copy);
  // Decoders ignore chunks of unknown names.
  for (const { name, at } of chunks(new DataView(file)))
    if (name === 'EXIF') bytes.fill(0x5f, at - 8, at - 4);
  bytes[20] = (bytes[20] ?? 0) & ~EXIF_FLAG;
  return copy;
}

const EXIF_FLAG = 0x08;

/** The chunks behind the header; a truncated one ends the list. */
function chunks(view: DataView): readonly Chunk[] {
  const found: Chunk[] = [];
  for (let at = 12; at + 8 <= view.byteLength; ) {
    const size = view.getUint32(at + 4, true);
    if (at + 8 + size > view.byteLength) break;
    found.push({ name: latin(view, at, 4), at: at + 8, size });
    // Chunks have an even size.
    at += 8 + size + (size % 2);
  }
  return found;
}

function webpSize(view: DataView): Structure['size'] {
  if (view.byteLength < 30) return undefined;
  switch (latin(view, 12, 4)) {
    case 'VP8 ':
      return { width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff };
    case 'VP8L': {
      const bits = view.getUint32(21, true);
      return { width: (bits & 0x3fff) + 1, height: ((bits >>> 14) & 0x3fff) + 1 };
    }
    case 'VP8X': {
      const width = view.getUint16(24, true) | (view.getUint8(26) << 16);
      const height = view.getUint16(27, true) | (view.getUint8(29) << 16);
      return { width: width + 1, height: height + 1 };
    }
    default:
      return undefined;
  }
}
