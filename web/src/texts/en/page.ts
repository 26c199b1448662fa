/** The editor's own page. */
export const page = {
  hint: 'Drag a hand',
  samples: {
    gingerbread: 'gingerbread',
    octopus: 'octopus',
    cactus: 'cactus',
    cat: 'cat',
    giraffe: 'giraffe',
    snake: 'snake',
    robot: 'robot',
    salamander: 'salamander',
    portrait: 'portrait',
  },
};
