/** Names that the editor gives, and names in sentences. */
import type { Texts } from '../texts';
import { countedHandles, list, quoted } from './language';

export const names: Texts['names'] = {
  point: (number) => `punto de control ${number}`,
  bar: (number) => `barra ${number}`,
  polygon: (number) => `polígono ${number}`,
  handles: (count) => countedHandles(count),
  nothing: 'nada',
  aVirtualHandle: 'un punto auxiliar',
  virtualHandle: (number) => `punto auxiliar ${number}`,
  boundary: 'el contorno',
  all: (words) => list(words),
  parts: (parts) => parts.join(', '),
  sentences: (sentences) => sentences.join(' '),
  quoted,
};
