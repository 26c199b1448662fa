import type { Texts } from '../texts';

export const page: Texts['page'] = {
  hint: 'An einer Hand ziehen',
  samples: {
    gingerbread: 'Lebkuchenmann',
    octopus: 'Krake',
    cactus: 'Kaktus',
    cat: 'Katze',
    giraffe: 'Giraffe',
    snake: 'Schlange',
    robot: 'Roboter',
    salamander: 'Salamander',
    portrait: 'Porträt',
  },
};
