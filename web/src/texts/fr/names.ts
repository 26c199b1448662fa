/** Names that the editor gives, and names in sentences. */
import type { Texts } from '../texts';
import { counted, list, quoted } from './language';

export const names: Texts['names'] = {
  point: (number) => `poignée ${number}`,
  bar: (number) => `barre ${number}`,
  polygon: (number) => `polygone ${number}`,
  handles: (count) => counted(count, 'poignée'),
  nothing: 'rien',
  aVirtualHandle: 'un point auxiliaire',
  virtualHandle: (number) => `point auxiliaire ${number}`,
  boundary: 'le contour',
  all: (words) => list(words),
  parts: (parts) => parts.join(', '),
  sentences: (sentences) => sentences.join(' '),
  quoted,
};
