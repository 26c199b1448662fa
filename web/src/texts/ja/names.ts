/** Names that the editor gives, and names in sentences. */
import { joined } from '../language';
import type { Texts } from '../texts';
import { counted, list, quoted } from './language';

const PARTS = {
  head: '頭',
  neck: '首',
  body: '胴体',
  arm: '腕',
  leg: '脚',
  tail: '尾',
  part: '部分',
} as const;
const PLACES = { '': '', end: '先端', joint: '関節' } as const;
const HEIGHTS = { '': '', upper: '上', lower: '下' } as const;
const SIDES = { '': '', left: '左', right: '右' } as const;

export const names: Texts['names'] = {
  point: (number) => `ハンドル ${number}`,
  bar: (number) => `バー ${number}`,
  polygon: (number) => `多角形 ${number}`,
  limb: (part, height, side, limb, place, number) => {
    const where = SIDES[side] + HEIGHTS[height];
    return joined(
      [joined([`${where && `${where}の`}${PARTS[part]}`, limb]), joined([PLACES[place], number])],
      '、',
    );
  },
  position: (height, side, number) => joined([SIDES[side] + HEIGHTS[height] || '中央', number]),
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
