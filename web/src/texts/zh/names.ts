/** Names that the editor gives, and names in sentences. */
import { joined } from '../language';
import type { Texts } from '../texts';
import { handleCount, list, quoted } from './language';

const PARTS = {
  head: '头部',
  neck: '颈部',
  body: '身体',
  arm: '手臂',
  leg: '腿',
  tail: '尾巴',
  part: '部分',
} as const;
const PLACES = { '': '', end: '末端', joint: '关节' } as const;
const HEIGHTS = { '': '', upper: '上', lower: '下' } as const;
const SIDES = { '': '', left: '左', right: '右' } as const;

export const names: Texts['names'] = {
  point: (number) => `控制点 ${number}`,
  bar: (number) => `折线 ${number}`,
  polygon: (number) => `多边形 ${number}`,
  limb: (part, height, side, limb, place, number) => {
    const where = SIDES[side] + HEIGHTS[height];
    return joined(
      [
        joined([`${where && `${where}${height ? '方' : '侧'}`}${PARTS[part]}`, limb]),
        joined([PLACES[place], number]),
      ],
      '，',
    );
  },
  position: (height, side, number) => joined([SIDES[side] + HEIGHTS[height] || '中间', number]),
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
