/** Names that the editor gives, and names in sentences. */
import { counted, list, quoted } from './language';

export const names = {
  /** Handles that nobody has named, by their number. */
  point: (number: string) => `handle ${number}`,
  bar: (number: string) => `bar ${number}`,
  polygon: (number: string) => `polygon ${number}`,
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
