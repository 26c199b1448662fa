/** Poses of a rig: as sums of the motions of handles, or by the solver in a module. */
import { C2WarpError } from '../error';
import { NUMBERS } from './clip';
import { type PosedSites, posedSites } from './posing';
import type { Rig } from './rig';
import type { Handle } from './shares';
import type { Solved } from './solved';

/** The motions of all sites for the handles of a rig. @throws C2WarpError for poses without valid motions. */
export type Poser = (handles: readonly Handle[]) => PosedSites;

const loading = new WeakMap<Rig, Promise<Poser>>();

/** The poser of a rig, if it is available immediately; null if it needs the module, or cannot be posed. */
export const ownPoser = ({ shares, rest }: Rig): Poser | null =>
  shares && ((handles) => posedSites(shares, handles, rest));

/**
 * Loads the module, once for all players of a rig.
 *
 * @throws C2WarpError if it does not load.
 */
export function solverOf(rig: Rig, solved: Solved): Promise<Poser> {
  const known = loading.get(rig) ?? load(solved);
  loading.set(rig, known);
  known.catch(() => loading.delete(rig));
  return known;
}

async function load({ section, driven }: Solved): Promise<Poser> {
  try {
    const { modulePoser } = await import('./module_poser');
    const motionsOf = await modulePoser(section);
    return (handles) => {
      try {
        return sitesOf(motionsOf(posesOf(handles)), driven.length);
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
export const posesOf = (handles: readonly Handle[]) => Float64Array.from(handles.flatMap(numbersOf));

const numbersOf = ({ posed, rotation, scale, depth }: Handle): number[] => [
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
