/** Names that the editor gives, and names in sentences. */
import { joined } from '../language';
import type { Texts } from '../texts';
import { counted, list, quoted } from './language';

const PARTS = {
  head: 'tête',
  neck: 'cou',
  body: 'corps',
  arm: 'bras',
  leg: 'jambe',
  tail: 'queue',
  part: 'partie',
} as const;
const FEMININE: readonly string[] = ['head', 'leg', 'tail', 'part'];
const PLACES = { '': '', end: 'extrémité', joint: 'articulation' } as const;

export const names: Texts['names'] = {
  point: (number) => `poignée ${number}`,
  bar: (number) => `barre ${number}`,
  polygon: (number) => `polygone ${number}`,
  limb: (part, height, side, limb, place, number) => {
    const ending = FEMININE.includes(part) ? 'e' : '';
    const aside = { '': '', left: 'gauche', right: `droit${ending}` }[side];
    const high = { '': '', upper: `supérieur${ending}`, lower: `inférieur${ending}` }[height];
    return joined([joined([PARTS[part], aside, high, limb]), joined([PLACES[place], number])], ', ');
  },
  position: (height, side, number) =>
    joined([
      { '': '', upper: 'en haut', lower: 'en bas' }[height],
      { '': height ? '' : 'au milieu', left: 'à gauche', right: 'à droite' }[side],
      number,
    ]),
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
