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

const joined = (words: readonly (string | undefined)[]): string => words.filter(Boolean).join(' ');

export const names: Texts['names'] = {
  point: (number) => `Griff ${number}`,
  bar: (number) => `Stab ${number}`,
  polygon: (number) => `Polygon ${number}`,
  limb: (part, height, side, limb, place, number) => {
    const ending = part === 'leg' ? 'es' : 'er';
    const [high, aside] = [HEIGHTS[height], SIDES[side]].map((word) => word && word + ending);
    const [name, at] = [
      [high, aside, PARTS[part], limb],
      [PLACES[place], number],
    ].map(joined);
    return [name, at].filter(Boolean).join(', ');
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
