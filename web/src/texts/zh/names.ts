/** Names that the editor gives, and names in sentences. */
import type { Texts } from '../texts';
import { handleCount, list, quoted } from './language';

export const names: Texts['names'] = {
  point: (number) => `控制点 ${number}`,
  bar: (number) => `折线 ${number}`,
  polygon: (number) => `多边形 ${number}`,
  handles: handleCount,
  nothing: '无',
  aVirtualHandle: '某个辅助点',
  virtualHandle: (number) => `辅助点 ${number}`,
  boundary: '轮廓',
  all: (words) => list(words),
  parts: (parts) => parts.join('，'),
  sentences: (sentences) => sentences.join(''),
  quoted,
};
