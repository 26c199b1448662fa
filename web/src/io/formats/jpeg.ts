/**
 * The structure of JPEG files (ITU-T T.81, annex B), as `wasm/cli/src/picture/jpeg.rs` reads it.
 *
 * Segments are skipped by their length. Scan data ends at the next marker, because it never contains one. Some cameras
 * omit the marker "end of image", or write their own data instead. Such a file is complete if its scans are complete.
 * Scan data has no length, so a decoder must find out: see {@link probes}.
 */
import type { Structure } from './structure';

const START_OF_SCAN = 0xda;
const END_OF_IMAGE = 0xd9;
/** Each probe decodes to different blocks. Decoders take missing bits for 0. */
const FILLERS = [0x33, 0xcc].map((byte) => new Uint8Array(64).fill(byte));

export function jpegHeader(view: DataView): Structure {
  const file = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
  const bits = new MissingBits();
  let size: Structure['size'];
  let [at, inScan, lastScan] = [0, false, 0];
  for (;;) {
    const marker = nextMarker(file, at);
    if (inScan && bits.isEmpty) lastScan ||= marker?.start ?? file.length;
    if (marker?.code === END_OF_IMAGE) return { size, end: 'found', moves: false };
    const segment = marker && segmentAt(view, marker);
    if (!segment) return { size, end: lastScan > 0 ? lastScan : 'missing', moves: false };
    inScan = marker.code === START_OF_SCAN;
    if (inScan) bits.scan(segment);
    else if (isFrame(marker.code) && segment.byteLength >= 5) {
      size ??= { width: segment.getUint16(3), height: segment.getUint16(1) };
      bits.frame(segment);
    }
    at = segment.byteOffset - view.byteOffset + segment.byteLength;
  }
}

/**
 * Files that end with a marker. They decode to the same pixels if the last scan of an unmarked file is complete.
 *
 * In all files but the first, filler follows the scan. Decoders ignore it after they have decoded every block.
 */
export function probes(file: ArrayBuffer, endOfScan: number): readonly Blob[] {
  const scanned = new Uint8Array(file, 0, endOfScan);
  const marker = Uint8Array.of(0xff, END_OF_IMAGE);
  return [new Uint8Array(), ...FILLERS].map(
    (filler) => new Blob([scanned, filler, marker], { type: 'image/jpeg' }),
  );
}

interface Marker {
  readonly start: number;
  readonly code: number;
  /** The position behind it. */
  readonly end: number;
}

/** Returns the next marker that is neither a stuffed byte of a scan nor a restart. */
function nextMarker(file: Uint8Array, from: number): Marker | undefined {
  for (let start = file.indexOf(0xff, from); start >= 0; ) {
    let end = start + 1;
    while (file[end] === 0xff) end++;
    const code = file[end++];
    if (code === undefined) return undefined;
    // 0 marks a stuffed byte 0xff of a scan. 0xd0 to 0xd7 restart a scan, 0xd8 starts the image, 1 is temporary.
    if (code > 1 && (code < 0xd0 || code > 0xd8)) return { start, code, end };
    start = file.indexOf(0xff, end);
  }
  return undefined;
}

/** Returns the contents of the segment behind a marker; undefined if the file ends before. */
function segmentAt(view: DataView, { end }: Marker): DataView | undefined {
  if (end + 2 > view.byteLength) return undefined;
  const size = Math.max(2, view.getUint16(end));
  return end + size <= view.byteLength
    ? new DataView(view.buffer, view.byteOffset + end + 2, size - 2)
    : undefined;
}

/** Whether a marker is SOF0 to SOF15. DHT, JPG and DAC have codes in the same range. */
const isFrame = (code: number): boolean =>
  code >= 0xc0 && code <= 0xcf && code !== 0xc4 && code !== 0xc8 && code !== 0xcc;

/**
 * The low bits that no scan has provided yet, for each component of the frame and each of its 64 coefficients.
 *
 * A sequential scan provides all bits. A progressive scan provides some coefficients, at first without their lowest
 * bits.
 */
class MissingBits {
  readonly #components = new Map<number, Uint8Array>();

  get isEmpty(): boolean {
    const components = [...this.#components.values()];
    return components.length > 0 && components.every((bits) => bits.every((bit) => bit === 0));
  }

  /** Reads a frame header (B.2.2). */
  frame(segment: DataView): void {
    for (let at = 6; at + 3 <= segment.byteLength; at += 3) {
      this.#components.set(segment.getUint8(at), new Uint8Array(64).fill(255));
    }
  }

  /** Reads a scan header (B.2.3). */
  scan(segment: DataView): void {
    const components = segment.byteLength > 0 ? segment.getUint8(0) : 0;
    const after = 1 + 2 * components;
    if (after + 3 !== segment.byteLength) return;
    const [first, last] = [segment.getUint8(after), segment.getUint8(after + 1)];
    for (let at = 1; at < after; at += 2) {
      this.#components.get(segment.getUint8(at))?.fill(segment.getUint8(after + 2) & 15, first, last + 1);
    }
  }
}
