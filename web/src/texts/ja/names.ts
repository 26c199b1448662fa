/** Names that the editor gives, and names in sentences. */
import type { Texts } from '../texts';
import { counted, list, quoted } from './language';

export const names: Texts['names'] = {
  point: (number) => `ハンドル ${number}`,
  bar: (number) => `バー ${number}`,
  polygon: (number) => `多角形 ${number}`,
  handles: (count) => counted(count, 'ハンドル'),
  nothing: '対象なし',
  aVirtualHandle: '補助点',
  virtualHandle: (number) => `補助点 ${number}`,
  boundary: '輪郭',
  all: (words) => list(words),
  parts: (parts) => parts.join('、'),
  sentences: (sentences) => sentences.join(''),
  quoted,
};
