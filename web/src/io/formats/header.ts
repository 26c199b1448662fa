/**
 * Reads a picture file before it is decoded. Browsers show truncated pictures without an error, and handle animations
 * and orientations differently, so the file must be read.
 */
import { gifHeader } from './gif';
import { jpegHeader } from './jpeg';
import { pngHeader } from './png';
import { brandsOf, type Kind, type Signature, signatureOf } from './signature';
import type { Structure } from './structure';
import { webpHeader } from './webp';

export interface Header extends Signature, Structure {}

export function readHeader(file: ArrayBuffer): Header {
  const view = new DataView(file);
  const signature = signatureOf(view);
  return { ...signature, ...structureOf(view, signature.kind) };
}

function structureOf(view: DataView, kind: Kind): Structure {
  switch (kind) {
    case 'png':
      return pngHeader(view);
    case 'jpeg':
      return jpegHeader(view);
    case 'webp':
      return webpHeader(view);
    case 'gif':
      return gifHeader(view);
    default:
      return { size: undefined, end: 'found', moves: brandsOf(view).includes('avis') };
  }
}
