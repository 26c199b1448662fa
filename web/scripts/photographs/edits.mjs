/**
 * The ten edits, as a user makes them: draw around a part, place handles, drag them. Coordinates are pixels of the
 * pictures in `tests/quality/photographs/pictures`.
 *
 * `choose` draws the lasso and the handles, and does not change the picture. `edit` moves the handles.
 */

/** @typedef {import('./hand.mjs').Hand} Hand */
/**
 * @typedef {object} Edit
 * @property {string} name The edit.
 * @property {string} picture Its picture, without the ending.
 * @property {import('./hand.mjs').Place} grip Where it is moved while frames are timed.
 * @property {(hand: Hand) => Promise<void>} choose
 * @property {(hand: Hand) => Promise<void>} edit
 */

/** @type {readonly Edit[]} */
export const EDITS = [
  {
    name: 'an ear pulled',
    picture: 'dog',
    grip: [690, 26],
    async choose(hand) {
      // Around the ear and a part of the head, with room for the ear to grow.
      await hand.lasso(
        [
          [628, 20],
          [660, 4],
          [700, 3],
          [725, 30],
          [738, 82],
          [738, 112],
          [700, 132],
          [660, 122],
          [640, 80],
        ],
        { snap: false },
      );
      await hand.press('Lock its outline');
      await hand.points([690, 26], [680, 108], [712, 96]);
    },
    async edit(hand) {
      await hand.drag([690, 26], [662, 10]);
    },
  },
  {
    name: 'a smile',
    picture: 'astronaut',
    grip: [203, 139.5],
    async choose(hand) {
      await hand.lasso(
        [
          [186, 140],
          [196, 122],
          [224, 118],
          [252, 122],
          [262, 140],
          [254, 160],
          [240, 172],
          [222, 175],
          [204, 170],
          [192, 158],
        ],
        { snap: false },
      );
      await hand.press('Lock its outline');
      await hand.points([203, 139.5], [247.5, 139], [224, 143], [224, 157], [224, 131]);
    },
    async edit(hand) {
      await hand.drag([203, 139.5], [199.5, 135.5]);
      await hand.drag([247.5, 139], [251.5, 135]);
    },
  },
  {
    name: 'a duck slimmed',
    picture: 'duck',
    grip: [690, 470],
    async choose(hand) {
      await hand.lasso(
        [
          [140, 440],
          [260, 440],
          [400, 385],
          [520, 370],
          [540, 250],
          [570, 170],
          [650, 155],
          [705, 210],
          [745, 290],
          [760, 350],
          [735, 385],
          [730, 430],
          [735, 520],
          [700, 610],
          [640, 670],
          [560, 730],
          [400, 740],
          [250, 710],
          [190, 640],
          [150, 540],
        ],
        { snap: false },
      );
      await hand.points([190, 480], [620, 240], [690, 470], [640, 610], [300, 690]);
    },
    async edit(hand) {
      await hand.drag([690, 470], [640, 470]);
      await hand.drag([640, 610], [605, 585]);
    },
  },
  {
    name: 'an arm lowered',
    picture: 'liberty',
    grip: [100, 34],
    async choose(hand) {
      await hand.lasso(
        [
          [99, 11],
          [93, 13],
          [88, 21],
          [89, 30],
          [93, 36],
          [93, 60],
          [94, 72],
          [89, 80],
          [90, 88],
          [97, 102],
          [112, 97],
          [115, 88],
          [113, 80],
          [108, 72],
          [107, 60],
          [106, 38],
          [110, 30],
          [110, 20],
          [105, 13],
        ],
        { snap: false },
      );
      await hand.points([106, 92], [100, 93], [104, 80], [100, 34]);
    },
    async edit(hand) {
      await hand.drag([100, 34], [62, 54]);
    },
  },
  {
    name: 'a tower straightened',
    picture: 'pisa',
    grip: [154, 30],
    async choose(hand) {
      await hand.lasso(
        [
          [101, 253],
          [101, 212],
          [105, 175],
          [109, 128],
          [115, 84],
          [116, 56],
          [126, 46],
          [126, 28],
          [138, 19],
          [142, 17],
          [141, 1],
          [152, 1],
          [153, 16],
          [166, 18],
          [179, 25],
          [181, 46],
          [187, 58],
          [187, 80],
          [185, 130],
          [182, 170],
          [180, 212],
          [180, 253],
        ],
        { snap: false },
      );
      await hand.bar([141, 250], [154, 30]);
    },
    async edit(hand) {
      await hand.drag([154, 30], [141, 30]);
    },
  },
  {
    name: 'a horizon with bars',
    picture: 'horses',
    grip: [3, 338],
    async choose(hand) {
      await hand.setSwitch('Lock the outline', false);
      await hand.bar([3, 3], [897, 3]);
      await hand.bar([3, 580], [897, 580]);
      await hand.bar([3, 338], [897, 418]);
    },
    async edit(hand) {
      await hand.drag([3, 338], [3, 378]);
      await hand.drag([897, 418], [897, 378]);
    },
  },
  {
    name: 'a hair strand',
    picture: 'cat',
    grip: [5, 221],
    async choose(hand) {
      await hand.lasso(
        [
          [166, 213],
          [120, 209],
          [60, 208],
          [20, 211],
          [1, 216],
          [1, 229],
          [20, 222],
          [60, 221],
          [120, 221],
          [166, 227],
        ],
        { snap: false },
      );
      await hand.points([160, 219], [110, 215], [60, 214], [5, 221]);
    },
    async edit(hand) {
      await hand.drag([5, 221], [14, 186]);
      await hand.drag([60, 214], [62, 199]);
    },
  },
  {
    name: 'a product turned',
    picture: 'coffee',
    grip: [289, 122],
    async choose(hand) {
      await hand.lasso(
        [
          [172, 95],
          [182, 65],
          [210, 35],
          [250, 20],
          [290, 16],
          [335, 24],
          [375, 47],
          [400, 80],
          [407, 112],
          [398, 150],
          [386, 190],
          [366, 228],
          [340, 262],
          [300, 288],
          [262, 286],
          [240, 304],
          [212, 312],
          [194, 298],
          [194, 272],
          [208, 236],
          [184, 180],
        ],
        { snap: false },
      );
      await hand.press('Turn this part, bend the rest');
    },
    async edit(hand) {
      await hand.turn(await hand.middle('polygon 1'), -12);
    },
  },
  {
    name: "a pet's tail",
    picture: 'kitten',
    grip: [655, 482],
    async choose(hand) {
      await hand.lasso(
        [
          [790, 328],
          [770, 345],
          [735, 378],
          [700, 408],
          [662, 440],
          [640, 462],
          [636, 478],
          [644, 492],
          [668, 500],
          [694, 494],
          [735, 462],
          [772, 432],
          [806, 402],
          [850, 392],
          [885, 388],
          [898, 360],
          [897, 335],
          [880, 312],
          [850, 306],
          [815, 312],
        ],
        { snap: false },
      );
      await hand.points([860, 335], [865, 365], [790, 375], [720, 435], [655, 482]);
    },
    async edit(hand) {
      await hand.drag([655, 482], [622, 436]);
    },
  },
  {
    name: 'a rocket leaned',
    picture: 'rocket',
    grip: [322, 134],
    async choose(hand) {
      await hand.lasso(
        [
          [322, 122],
          [310, 146],
          [308, 180],
          [308, 260],
          [308, 330],
          [309, 404],
          [335, 404],
          [337, 330],
          [337, 260],
          [337, 180],
          [334, 146],
        ],
        { snap: false },
      );
      await hand.bar([322, 398], [322, 134]);
    },
    async edit(hand) {
      await hand.drag([322, 134], [366, 139]);
    },
  },
];
