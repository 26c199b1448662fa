/** The handles of a rig, and the sources that move its sites: see web/docs/rig-format.md. */
import type { Bytes } from './bytes';

export type Place = readonly [number, number];

/** A handle as in project files, with a list of corners: a point has one corner. */
export interface Handle {
  readonly id: string;
  readonly kind: 'point' | 'bar' | 'polygon';
  readonly rest: readonly Place[];
  readonly posed: readonly Place[];
  /** Degrees. Automatic rotations need the solver. */
  readonly rotation: number | 'auto';
  readonly scale: number;
  readonly depth: number;
}

export interface Anchor {
  readonly handle: number;
  readonly segment: number;
  readonly fraction: number;
}

/** A straight part of a bar or polygon. */
export interface Bone {
  readonly handle: number;
  readonly segment: number;
  readonly rest: readonly [Place, Place];
  readonly joints: readonly [number, number];
  readonly beyond: readonly [number, number];
  readonly beside: readonly [number, number];
}

export interface Share {
  /** The index of a handle, or after the handles, of a bone. */
  readonly source: number;
  share: number;
  /** The position of the share along the bone, from 0 to 1. */
  along: number;
}

/** Handles, the bones of bars and polygons, and the sites that these move. */
export interface Sources {
  readonly handles: readonly Handle[];
  readonly joints: readonly (readonly Anchor[])[];
  readonly bones: readonly Bone[];
  /** For each site, 0: virtual. 1: it does not move. 2 + k: it belongs to source k. */
  readonly driven: Uint32Array;
}

export interface Shares extends Sources {
  /** One row for each virtual site. */
  readonly rows: readonly (readonly Share[])[];
}

const UNKNOWN = 'refer to an unknown handle or bone';

const KINDS = ['point', 'bar', 'polygon'] as const;

const list = <Item>(length: number, item: () => Item) => Array.from({ length }, item);

const isSource = ({ handles, bones }: Omit<Sources, 'driven'>, source: number) =>
  source < handles.length ? handles[source]?.kind === 'point' : source < handles.length + bones.length;

export function readSources(from: Bytes, names: readonly string[], sites: number): Sources {
  const float = () => {
    const number = from.float();
    from.check(Number.isFinite(number), 'contain a number that is not finite');
    return number;
  };
  const pair = (): Place => [float(), float()];
  const handles = names.map((id, at): Handle => {
    const kind = from.byte();
    from.check(kind < 3 && id !== '' && names.indexOf(id) === at, 'have an invalid handle');
    const corners = kind === 0 ? 1 : from.count(32);
    from.check(corners > kind, 'have an invalid handle');
    const [rest, posed] = [list(corners, pair), list(corners, pair)];
    const [rotation, scale, depth] = [float(), float(), float()];
    from.check(scale > 0, 'have an invalid handle');
    return { id, kind: KINDS[kind] ?? 'point', rest, posed, rotation, scale, depth };
  });
  const place = () => {
    const [handle, segment] = [from.varint(), from.varint()];
    const { kind, rest } = handles[handle] ?? {};
    from.check(
      rest !== undefined && kind !== 'point' && segment < rest.length,
      'have bones that do not match their handles',
    );
    return { handle, segment };
  };
  const joints = list(from.count(), () => {
    const anchors = list(from.count(10), () => ({ ...place(), fraction: float() }));
    from.check(anchors.length > 0, 'have bones that do not match their handles');
    return anchors;
  });
  const joint = () => {
    const index = from.varint();
    from.check(index < joints.length, 'have bones that do not match their handles');
    return index;
  };
  const bones = list(from.count(68), (): Bone => {
    const [at, a, b] = [place(), pair(), pair()];
    from.check(a[0] !== b[0] || a[1] !== b[1], 'contain a bone of zero length');
    return { ...at, rest: [a, b], joints: [joint(), joint()], beyond: pair(), beside: pair() };
  });
  from.check(from.has(sites), 'end too early');
  const driven = Uint32Array.from({ length: sites }, () => {
    const kind = from.varint();
    from.check(kind < 2 || isSource({ handles, joints, bones }, kind - 2), UNKNOWN);
    return kind;
  });
  return { handles, joints, bones, driven };
}

export function readShares(from: Bytes, names: readonly string[], sites: number): Shares {
  const sources = readSources(from, names, sites);
  const { handles, driven } = sources;
  const check = (source: number) => {
    from.check(isSource(sources, source), UNKNOWN);
    return source;
  };
  const bits = from.byte();
  from.check(bits <= 24, 'have too many bits');
  const whole = 2 ** bits;
  let entries = 0;
  const counts = [...driven.filter((kind) => kind === 0)].map(() => {
    const count = from.varint();
    entries += count;
    from.check(from.has(entries), 'end too early');
    return count;
  });
  const rows = counts.map((count) => {
    let next = 0;
    return list(count, (): Share => {
      const source = check(next + from.varint());
      next = source + 1;
      return { source, share: 0, along: 0 };
    });
  });
  for (const row of rows) {
    let left = whole;
    for (const part of row) {
      const share = from.varint();
      left -= share;
      from.check(share > 0 && left >= 0, 'sum to more than 1');
      part.share = share / whole;
    }
  }
  for (const part of rows.flat()) {
    if (part.source < handles.length) continue;
    part.along = from.varint() / whole;
    from.check(part.along <= 1, 'lie beyond a bone');
  }
  return { ...sources, rows };
}
