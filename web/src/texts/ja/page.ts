/** The editor's own page. */
import type { Texts } from '../texts';

export const page: Texts['page'] = {
  hint: '手をドラッグ',
  samples: {
    gingerbread: 'ジンジャーブレッド',
    octopus: 'タコ',
    cactus: 'サボテン',
    cat: '猫',
    giraffe: 'キリン',
    snake: 'ヘビ',
    robot: 'ロボット',
    salamander: 'サンショウウオ',
    portrait: '肖像',
  },
};
