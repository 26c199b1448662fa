/** The editor's own page. */
import type { Texts } from '../texts';

export const page: Texts['page'] = {
  hint: 'Arrastrar una mano',
  samples: {
    gingerbread: 'galleta de jengibre',
    octopus: 'pulpo',
    cactus: 'cactus',
    cat: 'gato',
    giraffe: 'jirafa',
    snake: 'serpiente',
    robot: 'robot',
    salamander: 'salamandra',
    portrait: 'retrato',
  },
};
