/** Words about rigs for game engines. */
import type { EngineLoss, Errors } from '../document/engine_rig';
import { say, type Wording } from '../texts/wording';

/** A row of the table of a loss. */
export interface EngineLossRow {
  readonly of: Wording;
  readonly percentile: string;
  readonly largest: string;
}

/** @param clips their names. */
export function lossRows(
  { pose, random, clips: ofClips, between }: EngineLoss,
  clips: readonly string[],
): readonly EngineLossRow[] {
  const row = (of: Wording, [largest, percentile]: Errors): EngineLossRow => ({
    of,
    percentile: pixelsText(percentile),
    largest: pixelsText(largest),
  });
  return [
    row(say('engine.pose'), pose),
    row(say('engine.randomPoses'), random),
    ...ofClips.map((errors, k) => row(say('engine.clip', clips[k] ?? ''), errors)),
    row(say('engine.betweenVertices'), between),
  ];
}

const pixelsText = (pixels: number): string => (pixels < 0.005 ? '< 0.01' : pixels.toFixed(2));

/** The worst of all poses and clips, in a sentence. */
export function lossWords({ pose, random, clips }: EngineLoss): Wording {
  const all = [pose, random, ...clips];
  const worst = (k: 0 | 1) => pixelsText(Math.max(...all.map((errors) => errors[k] ?? 0)));
  return say('engine.loss', worst(1), worst(0));
}
