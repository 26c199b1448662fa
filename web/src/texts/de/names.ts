import { joined } from '../language';
import type { Texts } from '../texts';
import { handleCount, list, quoted } from './language';

const PARTS = {
  head: 'Kopf',
  neck: 'Hals',
  body: 'Körper',
  arm: 'Arm',
  leg: 'Bein',
  tail: 'Schwanz',
  part: 'Teil',
} as const;
const PLACES = { '': '', end: 'Ende', joint: 'Gelenk' } as const;
const HEIGHTS = { '': '', upper: 'ober', lower: 'unter' } as const;
const SIDES = { '': '', left: 'link', right: 'recht' } as const;

export const names: Texts['names'] = {
  point: (number) => `Griff ${number}`,
  bar: (number) => `Stab ${number}`,
  polygon: (number) => `Polygon ${number}`,
  limb: (part, height, side, limb, place, number) => {
    const ending = part === 'leg' ? 'es' : 'er';
    const ended = (word: string) => word && word + ending;
    const name = [ended(HEIGHTS[height]), ended(SIDES[side]), PARTS[part], limb];
    return joined([joined(name), joined([PLACES[place], number])], ', ');
  },
  position: (height, side, number) =>
    joined([
      { '': '', upper: 'oben', lower: 'unten' }[height],
      { '': height ? '' : 'Mitte', left: 'links', right: 'rechts' }[side],
      number,
    ]),
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
