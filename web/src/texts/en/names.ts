/** Names that the editor gives, and names in sentences. */
import { joined } from '../language';
import { counted, list, quoted } from './language';

export type Part = 'head' | 'neck' | 'body' | 'arm' | 'leg' | 'tail' | 'part';
export type Place = '' | 'end' | 'joint';
export type Height = '' | 'upper' | 'lower';
export type Side = '' | 'left' | 'right';

export const names = {
  /** Handles that nobody has named, by their number. */
  point: (number: string) => `handle ${number}`,
  bar: (number: string) => `bar ${number}`,
  polygon: (number: string) => `polygon ${number}`,
  /** A suggested handle: "left arm 2, end". Without a place, only the limb has a number. */
  limb: (part: Part, height: Height, side: Side, limb: string, place: Place, number: string) =>
    joined([joined([height, side, part, limb]), joined([place, number])], ', '),
  /** A suggested handle that lies on no limb: "top left". */
  position: (height: Height, side: Side, number: string) =>
    joined([height && { upper: 'top', lower: 'bottom' }[height], side || (height ? '' : 'middle'), number]),
  handles: (count: number) => counted(count, 'handle'),
  nothing: 'nothing',
  aVirtualHandle: 'a helper point',
  virtualHandle: (number: number) => `helper point ${number}`,
  boundary: 'the outline',
  /** Whatever the words are: names, or parts of a label. */
  all: (words: readonly string[]) => list(words),
  parts: (parts: readonly string[]) => parts.join(', '),
  /** Several sentences. */
  sentences: (sentences: readonly string[]) => sentences.join(' '),
  quoted,
};
