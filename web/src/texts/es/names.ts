/** Names that the editor gives, and names in sentences. */
import { joined } from '../language';
import type { Texts } from '../texts';
import { countedHandles, list, quoted } from './language';

const PARTS = {
  head: 'cabeza',
  neck: 'cuello',
  body: 'cuerpo',
  arm: 'brazo',
  leg: 'pierna',
  tail: 'cola',
  part: 'parte',
} as const;
const FEMININE: readonly string[] = ['head', 'leg', 'tail', 'part'];
const PLACES = { '': '', end: 'extremo', joint: 'articulación' } as const;

export const names: Texts['names'] = {
  point: (number) => `punto de control ${number}`,
  bar: (number) => `barra ${number}`,
  polygon: (number) => `polígono ${number}`,
  limb: (part, height, side, limb, place, number) => {
    const ending = FEMININE.includes(part) ? 'a' : 'o';
    const aside = { '': '', left: `izquierd${ending}`, right: `derech${ending}` }[side];
    const high = { '': '', upper: 'superior', lower: 'inferior' }[height];
    return joined([joined([PARTS[part], aside, high, limb]), joined([PLACES[place], number])], ', ');
  },
  position: (height, side, number) =>
    joined([
      { '': '', upper: 'arriba', lower: 'abajo' }[height],
      { '': height ? '' : 'centro', left: 'a la izquierda', right: 'a la derecha' }[side],
      number,
    ]),
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
