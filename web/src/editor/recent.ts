/** Recent work: edited pictures that gave way to others, oldest first, within bounds of number and size. */
import { isWorkedOn, type WorkSnapshot } from './work';

const MAX_RECENT = 10;
/** The sum of the files. */
const MAX_BYTES = 200e6;

/** The newest of the works within the bounds. */
export function bounded(recent: readonly WorkSnapshot[]): readonly WorkSnapshot[] {
  const sizes = recent.map(({ file }) => file.size);
  let first = recent.length;
  let bytes = 0;
  while (first > 0 && recent.length - first < MAX_RECENT) {
    bytes += sizes[first - 1] ?? 0;
    // The newest is kept whatever its size.
    if (bytes > MAX_BYTES && first < recent.length) break;
    first -= 1;
  }
  return first === 0 ? recent : recent.slice(first);
}

/** Adds work that gives way. Work without a step or a drawing is no loss. */
export const withReplaced = (
  recent: readonly WorkSnapshot[],
  replaced: WorkSnapshot | null,
): readonly WorkSnapshot[] => (replaced && isWorkedOn(replaced) ? bounded([...recent, replaced]) : recent);

/** The version of the open work that another tab stored, of which the person has not heard yet. */
export const otherVersion = (
  recent: readonly WorkSnapshot[],
  { name }: Pick<WorkSnapshot, 'name'>,
): WorkSnapshot | null => recent.findLast((work) => work.fromOtherTab && work.name === name) ?? null;

/** The same works, of which the person has heard. */
export const withoutVersions = (recent: readonly WorkSnapshot[]): readonly WorkSnapshot[] =>
  recent.some(({ fromOtherTab }) => fromOtherTab)
    ? recent.map(({ fromOtherTab: _, ...work }) => work)
    : recent;
