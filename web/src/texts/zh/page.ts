/** The editor's own page. */
import type { Texts } from '../texts';

export const page: Texts['page'] = {
  hint: '拖动一只手试试',
  samples: {
    gingerbread: '姜饼人',
    octopus: '章鱼',
    cactus: '仙人掌',
    cat: '猫',
    giraffe: '长颈鹿',
    snake: '蛇',
    robot: '机器人',
    salamander: '蝾螈',
    portrait: '肖像',
  },
};
