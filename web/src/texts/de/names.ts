import type { Texts } from '../texts';
import { handleCount, list, quoted } from './language';

export const names: Texts['names'] = {
  point: (number) => `Griff ${number}`,
  bar: (number) => `Stab ${number}`,
  polygon: (number) => `Polygon ${number}`,
  handles: handleCount,
  nothing: 'nichts',
  aVirtualHandle: 'ein Hilfspunkt',
  virtualHandle: (number) => `Hilfspunkt ${number}`,
  boundary: 'der Umriss',
  all: (words) => list(words),
  parts: (parts) => parts.join(', '),
  sentences: (sentences) => sentences.join(' '),
  quoted,
};
