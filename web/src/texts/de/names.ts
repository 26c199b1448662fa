import type { Texts } from '../texts';
import { handleCount, list, quoted } from './language';

export const names: Texts['names'] = {
  point: (number) => `Griff ${number}`,
  bar: (number) => `Stab ${number}`,
  polygon: (number) => `Polygon ${number}`,
  handles: handleCount,
  nothing: 'nichts',
  aVirtualHandle: 'ein virtueller Griff',
  virtualHandle: (number) => `virtueller Griff ${number}`,
  boundary: 'der Rand',
  all: (words) => list(words),
  parts: (parts) => parts.join(', '),
  sentences: (sentences) => sentences.join(' '),
  quoted,
};
