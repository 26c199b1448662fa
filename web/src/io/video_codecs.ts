/**
 * The codecs that a browser can encode a film with, in the order of preference.
 *
 * A codec's string names its profile and its level: the size and rate that a player must cope with. The tables are
 * those of ITU-T H.264 (A.3), of the WebM project and of AOMedia.
 */

export type VideoFormat = 'webm' | 'mp4';
export type VideoCodec = 'vp9' | 'vp8' | 'avc' | 'av1';

/** Pixels, and frames a second. */
export interface VideoShape {
  readonly width: number;
  readonly height: number;
  readonly rate: number;
}

export interface CodecChoice {
  readonly codec: VideoCodec;
  /** For WebCodecs, such as `vp09.00.31.08`. */
  readonly config: string;
  /** Pixels of the film: some codecs have only even sides. */
  readonly width: number;
  readonly height: number;
}

/** Only the codecs of WebM carry transparency. MP4 plays nearly everywhere with AVC. */
export const CODECS: Readonly<Record<VideoFormat, readonly VideoCodec[]>> = {
  webm: ['vp9', 'vp8'],
  mp4: ['avc', 'vp9', 'av1'],
};

/** Level, pixels of a frame at most, pixels a second at most. */
type Level = readonly [level: number, pixels: number, pixelsPerSecond: number];

/** In macroblocks of 16 × 16 pixels. */
const AVC: readonly Level[] = [
  [30, 1620, 40_500],
  [31, 3600, 108_000],
  [32, 5120, 216_000],
  [40, 8192, 245_760],
  [42, 8704, 522_240],
  [50, 22_080, 589_824],
  [51, 36_864, 983_040],
  [52, 36_864, 2_073_600],
  [62, 139_264, 16_711_680],
];

const VP9: readonly Level[] = [
  [10, 36_864, 829_440],
  [11, 73_728, 2_764_800],
  [20, 122_880, 4_608_000],
  [21, 245_760, 9_216_000],
  [30, 552_960, 20_736_000],
  [31, 983_040, 36_864_000],
  [40, 2_228_224, 83_558_400],
  [41, 2_228_224, 160_432_128],
  [50, 8_912_896, 311_951_360],
  [51, 8_912_896, 588_251_136],
  [52, 8_912_896, 1_176_502_272],
  [62, 35_651_584, 4_706_009_088],
];

const AV1: readonly Level[] = [
  [0, 147_456, 5_529_600],
  [1, 278_784, 10_454_400],
  [4, 665_856, 24_969_600],
  [5, 1_065_024, 39_938_400],
  [8, 2_359_296, 77_856_768],
  [9, 2_359_296, 155_713_536],
  [12, 8_912_896, 273_715_200],
  [13, 8_912_896, 547_430_400],
  [14, 8_912_896, 1_094_860_800],
  [18, 35_651_584, 4_706_009_088],
];

/** The least level that holds frames and rate, or the greatest of all. */
function levelOf(levels: readonly Level[], pixels: number, rate: number): number {
  const fits = levels.find(([, most, perSecond]) => pixels <= most && pixels * rate <= perSecond);
  return (fits ?? levels.at(-1))?.[0] ?? 0;
}

const twoDigits = (number: number, radix = 10): string => number.toString(radix).padStart(2, '0');

/** The configurations of a codec, from the best. */
export function configsOf(codec: VideoCodec, { width, height, rate }: VideoShape): readonly string[] {
  const pixels = width * height;
  switch (codec) {
    case 'vp8':
      return ['vp8'];
    case 'vp9':
      return [`vp09.00.${twoDigits(levelOf(VP9, pixels, rate))}.08`];
    case 'av1':
      return [`av01.0.${twoDigits(levelOf(AV1, pixels, rate))}M.08`];
    case 'avc': {
      const level = twoDigits(levelOf(AVC, Math.ceil(width / 16) * Math.ceil(height / 16), rate), 16);
      // High, main and baseline profile.
      return ['6400', '4d00', '42e0'].map((profile) => `avc1.${profile}${level}`);
    }
  }
}

/** AVC and AV1 have even sides in practice: a column or a row is added. */
export function codedShape(codec: VideoCodec, shape: VideoShape): VideoShape {
  if (codec === 'vp8' || codec === 'vp9') return shape;
  const even = (side: number) => side + (side % 2);
  return { ...shape, width: even(shape.width), height: even(shape.height) };
}

/** The best codec that this browser encodes; null without one. */
export async function findCodec(format: VideoFormat, shape: VideoShape): Promise<CodecChoice | null> {
  if (typeof VideoEncoder === 'undefined') return null;
  for (const codec of CODECS[format]) {
    const coded = codedShape(codec, shape);
    for (const config of configsOf(codec, coded)) {
      if (await isEncodable(config, coded))
        return { codec, config, width: coded.width, height: coded.height };
    }
  }
  return null;
}

async function isEncodable(codec: string, { width, height, rate }: VideoShape): Promise<boolean> {
  try {
    const { supported } = await VideoEncoder.isConfigSupported({ codec, width, height, framerate: rate });
    return supported === true;
  } catch {
    // An unknown codec, or an impossible size.
    return false;
  }
}
