/** Texts about rigs for game engines. */
import type { EngineFormat, EngineLoss, Errors } from '../document/engine_rig';

export const ENGINE_NOTES: Readonly<Record<EngineFormat, string>> = {
  spine: 'Spine 4.2 and its runtimes: JSON, atlas and PNG.',
  dragonbones: 'DragonBones 5.5 and its runtimes: two JSON files and a PNG.',
  gltf: 'glTF 2.0 for three.js, Blender and others: one file.',
  godot: 'A scene of Godot 4 with its PNG.',
};

/** @param clips their number. */
export function engineClipsText(clips: number): string {
  if (clips === 0) return 'Mesh, bones and pose. There is no clip yet.';
  return clips === 1 ? 'With the clip as an animation.' : `With ${clips} clips as animations.`;
}

export const ROUGH_NOTE =
  'Bones blend more simply than handles, so a rig is a little off. The export tells how far.';

/** A row of the table of a loss. */
export interface EngineLossRow {
  readonly of: string;
  readonly percentile: string;
  readonly largest: string;
}

/** @param clips their names. */
export function lossRows(
  { pose, random, clips: ofClips, between }: EngineLoss,
  clips: readonly string[],
): readonly EngineLossRow[] {
  const row = (of: string, [largest, percentile]: Errors): EngineLossRow => ({
    of,
    percentile: pixelsText(percentile),
    largest: pixelsText(largest),
  });
  return [
    row('Pose', pose),
    row('Random poses', random),
    ...ofClips.map((errors, k) => row(`Clip ${clips[k] ?? ''}`, errors)),
    row('Between vertices', between),
  ];
}

const pixelsText = (pixels: number): string => (pixels < 0.005 ? '< 0.01' : pixels.toFixed(2));

/** The worst of all poses and clips, in a sentence. */
export function lossText({ pose, random, clips }: EngineLoss): string {
  const all = [pose, random, ...clips];
  const [largest, percentile] = [0, 1].map((k) =>
    pixelsText(Math.max(...all.map((errors) => errors[k] ?? 0))),
  );
  return `99 % of vertices are off by at most ${percentile} px, the worst by ${largest} px.`;
}

/** The caption of the table of a loss. */
export const lossCaption = ({ bones, sites, vertices }: EngineLoss): string =>
  `The last rig has ${bones} bones for ${sites} sites, and ${vertices} vertices. It is off by, in pixels:`;
