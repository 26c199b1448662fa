/** Poses of a rig: as sums of the motions of handles, or by the solver in a module. */
import { C2WarpError } from '../error';
import { NUMBERS } from './clip';
import { type PosedSites, posedSites } from './posing';
import type { Rig } from './rig';
import type { Handle } from './shares';
import type { Solved } from './solved';

/**
 * The motions of all sites for the handles of a rig. Without `before`, they depend on nothing else, and are the same on
 * every machine. Otherwise, they continue those motions, sites × 6: as the next frame of a drag, or where it rests.
 *
 * @throws C2WarpError for poses without valid motions.
 */
export type Poser = (handles: readonly Handle[], before?: Float64Array, rests?: boolean) => PosedSites;

const loading = new WeakMap<Rig, Promise<Poser>>();

/**
 * The poser of a rig, if it is available immediately; null if it needs the module, or cannot be posed. It takes sums,
 * which do not depend on the motions before.
 */
export const ownPoser = ({ shares, rest }: Rig): Poser | null =>
  shares && ((handles) => posedSites(shares, handles, rest));

/**
 * Loads the module, once for all players of a rig.
 *
 * @throws C2WarpError if it does not load.
 */
export function solverOf(rig: Rig, solved: Solved): Promise<Poser> {
  const known = loading.get(rig) ?? load(rig, solved);
  loading.set(rig, known);
  known.catch(() => loading.delete(rig));
  return known;
}

async function load(rig: Rig, { section, driven }: Solved): Promise<Poser> {
  try {
    const { modulePoser } = await import('./module_poser');
    const motionsOf = await modulePoser(section, rig);
    return (handles, before, rests) => {
      try {
        return sitesOf(motionsOf(posesOf(handles), before && numbersOf(before), rests), driven.length);
      } catch (cause) {
        throw new C2WarpError('rig', `This pose cannot be shown: ${wordsOf(cause)}.`, { cause });
      }
    };
  } catch (cause) {
    throw new C2WarpError('engine', `The handles cannot be posed: ${wordsOf(cause)}.`, { cause });
  }
}

const wordsOf = (error: unknown) => (error as Error).message.replace(/\.$/, '');

/** The format of `HandlePose::from_numbers` in wasm/core/src/deform. */
export const posesOf = (handles: readonly Handle[]) => Float64Array.from(handles.flatMap(poseOf));

const poseOf = ({ posed, rotation, scale, depth }: Handle): number[] => [
  posed.length,
  rotation === 'auto' ? Number.NaN : rotation,
  scale,
  depth,
  ...posed.flat(),
];

/** @param numbers the numbers of a motion, and a depth, for each site. */
export function sitesOf(numbers: Float64Array, sites: number): PosedSites {
  const motions = new Float64Array(sites * NUMBERS);
  const depths = new Float64Array(sites);
  for (let site = 0; site < sites; site++) {
    const at = site * (NUMBERS + 1);
    motions.set(numbers.subarray(at, at + NUMBERS), site * NUMBERS);
    depths[site] = numbers[at + NUMBERS] ?? 0;
  }
  return { motions, depths };
}

/** The format of `sitesOf`. Depths do not matter to poses that continue these. @param motions sites × 6. */
export function numbersOf(motions: Float64Array): Float64Array {
  const numbers = new Float64Array((motions.length / NUMBERS) * (NUMBERS + 1));
  for (let from = 0, to = 0; from < motions.length; from += NUMBERS, to += NUMBERS + 1)
    numbers.set(motions.subarray(from, from + NUMBERS), to);
  return numbers;
}
