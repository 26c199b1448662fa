/** The pictures of the playground, by the names that projects have for them. */
export const SAMPLES = [
  'gingerbread',
  'cat',
  'octopus',
  'giraffe',
  'cactus',
  'snake',
  'robot',
  'salamander',
  'portrait',
] as const;

export type Sample = (typeof SAMPLES)[number];

/** The sample that a project is for, by the file name of its picture. */
export function sampleOf(project: unknown): Sample | undefined {
  const src = (project as { image?: { src?: unknown } } | null)?.image?.src;
  return SAMPLES.find((sample) => src === `${sample}.png`);
}
