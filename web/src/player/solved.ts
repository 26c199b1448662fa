/** The handles of a rig whose poses need the solver's module: see web/docs/rig-format.md. */
import type { Bytes } from './bytes';
import { readSources, type Sources } from './shares';

export interface Solved extends Sources {
  /** The module reads it. */
  readonly section: Uint8Array;
}

/** The latest supported format of the section. Earlier ones begin in the same way. */
const FORMAT = 2;

/** Null for a section of a later format. Then the rig cannot be posed. */
export function readSolved(
  from: Bytes,
  section: Uint8Array,
  names: readonly string[],
  sites: number,
): Solved | null {
  const format = from.byte();
  if (format < 1 || format > FORMAT) return null;
  from.check(from.varint() === names.length && names.length > 0, 'have other handles');
  from.check(from.varint() === sites, 'have other sites');
  const { handles, ...others } = readSources(from, names, sites);
  const turned = handles.map((handle) => {
    const turns = from.byte();
    from.check(turns < 2, 'have an invalid handle');
    return turns > 0 ? { ...handle, rotation: 'auto' as const } : handle;
  });
  return { ...others, handles: turned, section };
}
