/** Writes GIF files of up to eight colours. */
import { type Bytes, FLAG, latin, little16, type Pixels } from './bytes';
import { packed } from './webp';

const CLEAR = 8;
const END = 9;

/** A frame. So few pixels need no code but those of their colours. */
const frame = ({ width, height, colours }: Pixels): Bytes => {
  const codes = [CLEAR, ...colours.map((colour) => FLAG.colours.indexOf(colour)), END];
  const data = packed(codes.map((code) => [code, 4]));
  return [0x2c, ...[0, 0, width, height].flatMap(little16), ...[0, 3, data.length, ...data, 0]];
};

export const gif = (...frames: readonly Pixels[]): Bytes => [
  ...latin('GIF89a'),
  ...little16(FLAG.width),
  ...little16(FLAG.height),
  ...[0x82, 0, 0],
  ...[...FLAG.colours, [0, 0, 0], [0, 0, 0]].flatMap((colour) => colour.slice(0, 3)),
  ...frames.flatMap(frame),
  0x3b,
];
