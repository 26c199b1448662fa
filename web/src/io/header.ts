/**
 * Reads the kind and size of a picture file before it is decoded, and whether the file is complete. Browsers show
 * truncated pictures without an error, so the file must be checked.
 *
 * Supports PNG (3rd edition, §5), JPEG (ITU T.81, annex B) and WebP (its container). Other kinds count as complete.
 */
export interface Header {
  readonly kind: 'png' | 'jpeg' | 'webp' | 'svg' | 'other';
  /** Undefined if the file ends before its size, or the kind is not supported. */
  readonly size: { readonly width: number; readonly height: number } | undefined;
  /** False if the file ends before the picture does. */
  readonly complete: boolean;
}

export function readHeader(file: ArrayBuffer): Header {
  const view = new DataView(file);
  if (startsWith(view, '\x89PNG\r\n\x1a\n')) return png(view);
  if (startsWith(view, '\xff\xd8\xff')) return jpeg(view);
  if (startsWith(view, 'RIFF') && startsWith(view, 'WEBP', 8)) return webp(view);
  const kind = /^(\xef\xbb\xbf)?\s*<(\?xml|!--|!DOCTYPE svg|svg)/i.test(latin(view, 0, 256))
    ? 'svg'
    : 'other';
  return { kind, size: undefined, complete: true };
}

function png(view: DataView): Header {
  const size = view.byteLength >= 24 ? { width: view.getUint32(16), height: view.getUint32(20) } : undefined;
  // A chunk consists of length, name, data and checksum.
  for (let at = 8; at + 12 <= view.byteLength; at += 12 + view.getUint32(at)) {
    if (startsWith(view, 'IEND', at + 4)) return { kind: 'png', size, complete: true };
  }
  return { kind: 'png', size, complete: false };
}

function jpeg(view: DataView): Header {
  let size: Header['size'];
  let at = 2;
  while (at + 4 <= view.byteLength) {
    const marker = view.getUint16(at);
    if (isFrame(marker) && at + 9 <= view.byteLength) {
      size = { width: view.getUint16(at + 7), height: view.getUint16(at + 5) };
    }
    if (marker === START_OF_SCAN) return { kind: 'jpeg', size, complete: hasEndMarker(view, at) };
    // Markers may follow fill bytes, and decoders skip stray bytes too.
    at += marker === 0xffff || marker < 0xff00 ? 1 : 2 + view.getUint16(at + 2);
  }
  return { kind: 'jpeg', size, complete: false };
}

const START_OF_SCAN = 0xffda;

/** Whether a marker is SOF0 to SOF15. DHT, JPG and DAC have codes in the same range. */
const isFrame = (marker: number): boolean =>
  marker >= 0xffc0 && marker <= 0xffcf && marker !== 0xffc4 && marker !== 0xffc8 && marker !== 0xffcc;

/** Searches from the scan on: a thumbnail before the scan has its own end marker. */
function hasEndMarker(view: DataView, from: number): boolean {
  for (let at = view.byteLength - 2; at >= from; at--) {
    if (view.getUint8(at) === 0xff && view.getUint8(at + 1) === 0xd9) return true;
  }
  return false;
}

function webp(view: DataView): Header {
  const complete = view.getUint32(4, true) + 8 <= view.byteLength;
  return { kind: 'webp', size: webpSize(view), complete };
}

function webpSize(view: DataView): Header['size'] {
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

const startsWith = (view: DataView, text: string, at = 0): boolean => latin(view, at, text.length) === text;

/** Decodes up to `length` bytes as Latin-1; fewer at the end of the file. */
function latin(view: DataView, at: number, length: number): string {
  const end = Math.min(at + length, view.byteLength);
  return at < end ? String.fromCharCode(...new Uint8Array(view.buffer, at, end - at)) : '';
}
