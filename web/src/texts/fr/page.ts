/** The editor's own page. */
import type { Texts } from '../texts';

export const page: Texts['page'] = {
  hint: 'Tirez une main',
  samples: {
    gingerbread: 'pain d’épices',
    octopus: 'pieuvre',
    cactus: 'cactus',
    cat: 'chat',
    giraffe: 'girafe',
    snake: 'serpent',
    robot: 'robot',
    salamander: 'salamandre',
    portrait: 'portrait',
  },
};
