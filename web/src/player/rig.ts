/** Reads the file of a rig: see web/docs/rig-format.md. */
import { C2WarpError } from '../error';
import { type Bytes, bytesOf } from './bytes';
import { type RigClip, readClip } from './clip';
import { sectionsOf } from './file';
import { type Mesh, readDisplaced, readMesh, readWeights, type Weights } from './mesh';
import { readShares, type Shares } from './shares';
import { readSolved, type Solved } from './solved';

export interface Rig extends Mesh, Weights {
  /** Width and height of the picture, pixels. */
  readonly width: number;
  readonly height: number;
  readonly rigid: boolean;
  /** Whether edges are drawn where parts cross. */
  readonly edges: boolean;
  readonly handles: readonly string[];
  /** Vertices × 2: the positions before sites move them, image pixels. Texture coordinates are those of `positions`. */
  readonly displaced: Float32Array;
  /** Null if poses of handles need a solver. */
  readonly shares: Shares | null;
  /** Null if poses need no solver, and for a rig that cannot be posed. */
  readonly solved: Solved | null;
  /** The file of the picture. */
  readonly picture: Uint8Array<ArrayBuffer>;
  /** At least one. */
  readonly clips: readonly RigClip[];
}

/**
 * Reads a rig.
 *
 * @throws C2WarpError with a sentence for people if the bytes are not a rig, are damaged, or have an unknown version.
 */
export async function readRig(file: Uint8Array<ArrayBuffer>): Promise<Rig> {
  const { sections, isDisplaced } = await sectionsOf(file);
  const tags = isDisplaced
    ? /^(HEAD|PICT|MESH|WGHT|DISP|SHAR|POSR|CLIP)$/
    : /^(HEAD|PICT|MESH|WGHT|SHAR|POSR|CLIP)$/;
  const known = sections.filter(({ tag }) => tags.test(tag));
  const next = (wanted: string, part: string) => {
    const { tag, data } = known.shift() ?? {};
    if (!data || tag !== wanted) throw new C2WarpError('rig', `This rig is damaged: ${part} is missing.`);
    return data;
  };
  const read = <Part>(tag: string, part: string, parse: (from: Bytes) => Part): Part => {
    const from = bytesOf(part, next(tag, part));
    const parsed = parse(from);
    from.end();
    return parsed;
  };
  const head = read('HEAD', 'the head', (from) => {
    const [width, height, flags] = [from.varint(), from.varint(), from.byte()];
    from.check(width > 0 && height > 0, 'describes an empty picture');
    from.check(flags < 4, 'has an unknown setting');
    const handles = Array.from({ length: from.count() }, () => from.text());
    return { width, height, rigid: (flags & 1) > 0, edges: (flags & 2) > 0, handles };
  });
  const picture = next('PICT', 'the picture');
  const mesh = read('MESH', 'the mesh', readMesh);
  const sites = mesh.rest.length / 2;
  const weights = read('WGHT', 'the weights', (from) => readWeights(from, mesh.positions.length / 2, sites));
  const displaced = isDisplaced
    ? read('DISP', 'the displacement', (from) => readDisplaced(from, mesh))
    : mesh.positions;
  // The module reads the rest.
  const readSection = (section: Uint8Array) =>
    readSolved(bytesOf('the poses', section), section, head.handles, sites);
  const shares =
    known[0]?.tag === 'SHAR'
      ? read('SHAR', 'the shares', (from) => readShares(from, head.handles, sites))
      : null;
  const solved = known[0]?.tag === 'POSR' ? readSection(next('POSR', 'the poses')) : null;
  const clips: RigClip[] = [];
  do {
    const clip = read('CLIP', 'a clip', (from) => readClip(from, sites, mesh.triangles.length / 3));
    if (clips.some(({ name }) => name === clip.name))
      throw new C2WarpError('rig', 'This rig is damaged: two clips have the same name.');
    clips.push(clip);
  } while (known.length > 0);
  return { ...head, ...mesh, ...weights, displaced, shares, solved, picture, clips };
}
