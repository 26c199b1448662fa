/** The structure of PNG files (3rd edition, sections 5 and 11). */

import { latin } from './latin';
import type { Structure } from './structure';

export function pngHeader(view: DataView): Structure {
  const size = view.byteLength >= 24 ? { width: view.getUint32(16), height: view.getUint32(20) } : undefined;
  let moves = false;
  // A chunk consists of length, name, data and checksum.
  for (let at = 8; at + 12 <= view.byteLength; at += 12 + view.getUint32(at)) {
    const name = latin(view, at + 4, 4);
    // Animation control: the number of frames comes first.
    if (name === 'acTL') moves = view.getUint32(at + 8) > 1;
    if (name === 'IEND') return { size, end: 'found', moves };
  }
  return { size, end: 'missing', moves };
}
