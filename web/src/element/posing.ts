/** The posed picture as geometry: the motions that draw it, and lookups between places on it and in the original. */
import { blendOf } from '../document/bending';
import type { Document } from '../document/document';
import { anchor, isAutomatic, rounded, type Turns } from '../document/handle';
import type { History } from '../document/history';
import type { Project } from '../document/project';
import { posedPositions } from '../geometry/blend';
import { type Borders, posedBorders } from '../geometry/borders';
import { type Box, boxAround, boxOfBoth, reachesBeyond } from '../geometry/box';
import { coverageOf } from '../geometry/coverage';
import { DrawingOrder } from '../geometry/drawing_order';
import { type FoldingMesh, foldCount, foldedTriangles, foldingMesh } from '../geometry/folds';
import { type Located, locateNear, locatePosed } from '../geometry/locate';
import { type Skin, siteTurn } from '../geometry/skin';
import { type Spot, spotAt } from '../geometry/spot';
import type { Vec } from '../geometry/vec';
import type { Placement } from '../tools/state';
import type { FoldedMesh, SiteGraph } from '../ui/overlays';
import type { Solving } from './solving';

/** Image pixels beyond the frame that nobody misses; also covers rounding. */
const SLACK = 0.5;

export class Posing {
  readonly #history: History<Document>;
  readonly #solving: Solving;
  #project: Project | null = null;
  #motions: Float32Array | null = null;
  #posed: Float32Array | null = null;
  #turns: Turns | null = null;
  #folds: number | null = null;
  #folding: FoldingMesh | null = null;
  #order: DrawingOrder | null = null;
  #coverage: Float32Array | null = null;

  constructor(history: History<Document>, solving: Solving) {
    this.#history = history;
    this.#solving = solving;
  }

  /** Clears all cached values, for another solution. */
  forget(): void {
    this.#project = null;
    this.#motions = null;
    this.#posed = null;
    this.#turns = null;
    this.#folds = null;
    this.#folding = null;
    this.#order = null;
    this.#coverage = null;
  }

  /** The motions of all sites in the current pose; null without a solution. */
  motions(): Float32Array | null {
    const { project } = this.#history.present;
    if (project !== this.#project) {
      this.#project = project;
      this.#motions = this.#newest(project);
      this.#posed = null;
      this.#turns = null;
      this.#folds = null;
    }
    return this.#motions;
  }

  /** Turns of automatic handles: from their own sites, or from the picture around handles not solved yet. */
  turns(): Turns {
    const motions = this.motions();
    this.#turns ??= motions ? this.#turnsUnder(motions) : new Map();
    return this.#turns;
  }

  /**
   * Where a handle can be placed on the posed picture: there, or at most `within` away. Without a solution the point of
   * the original is the place itself.
   */
  place(at: Vec, within: number): Spot | null {
    const { picture, current } = this.#solving;
    if (!picture) return null;
    if (current) {
      const { samples } = current.data.report;
      return spotAt(this.#drawn(current.data), samples, this.#positions(), at, within);
    }
    const inside = at[0] >= 0 && at[1] >= 0 && at[0] < picture.width && at[1] < picture.height;
    return inside ? { at, rest: at, rotation: 0, scale: 1 } : null;
  }

  /** What lies at a place of the posed picture; beside it as if its nearest part continued there. */
  placeNear(at: Vec): Placement {
    const { current } = this.#solving;
    const near = current && locateNear(this.#drawn(current.data), this.#positions(), at);
    return near ?? { rest: at, rotation: 0, scale: 1 };
  }

  /** The number of triangles that the current pose turns over. */
  folds(): number {
    this.motions();
    this.#folds ??= foldCount(this.#foldable, this.#positions());
    return this.#folds;
  }

  /** `folds` for any pose, counted up to `limit` + 1; infinite if the solver cannot pose it. */
  foldsOf(project: Project, limit: number): number {
    const { current } = this.#solving;
    if (!current) return 0;
    try {
      const posed = posedPositions(current.data, this.#solving.motions(project), blendOf(project));
      return foldCount(this.#foldable, posed, limit);
    } catch {
      return Number.POSITIVE_INFINITY;
    }
  }

  /** The triangles that the current pose turns over; null if there are none. */
  folded(): FoldedMesh | null {
    if (this.folds() === 0) return null;
    const posed = this.#positions();
    return { posed, triangles: foldedTriangles(this.#foldable, posed) };
  }

  /** Bounding box of the posed picture without the mesh around its rim, image pixels; null without a solution. */
  bounds(): Box | null {
    const { current } = this.#solving;
    if (!current) return null;
    const posed = boxAround(this.#positions(), current.data.report.samples);
    const still = boxAround(current.data.backgroundPositions, current.data.backgroundPositions.length / 2);
    return posed && still ? boxOfBoth(posed, still) : posed;
  }

  /** Bounding box of what bends, at rest, image pixels; null without a solution. */
  restBounds(): Box | null {
    const data = this.#solving.current?.data;
    return data ? boxAround(data.positions, data.report.samples) : null;
  }

  /** Whether part of the posed picture lies outside the picture's own rectangle. */
  beyond(): boolean {
    const { picture } = this.#solving;
    const bounds = this.bounds();
    if (!picture || !bounds) return false;
    return reachesBeyond(bounds, { min: [0, 0], max: [picture.width, picture.height] }, SLACK);
  }

  /** Where a point of the original is posed; null outside the warped area. */
  map(rest: Vec): Located | null {
    const { current } = this.#solving;
    if (!current) return null;
    return locatePosed(current.data, this.motions(), blendOf(this.#history.present.project), rest);
  }

  /** Whether a point of the original is part of what bends: not of the rim that is drawn around it. */
  bends(rest: Vec): boolean {
    const { current } = this.#solving;
    if (!current) return false;
    const { data } = current;
    return spotAt(data, data.report.samples, data.positions, rest, 0)?.at === rest;
  }

  /** Where the borders between cells are in the current pose: pieces × 2 ends × 2. */
  posed(borders: Borders): Float32Array {
    return posedBorders(borders, this.#positions());
  }

  /** How many sites move each vertex, see `coverageOf`; null without a solution. */
  coverage(): Float32Array | null {
    const data = this.#solving.current?.data;
    this.#coverage ??= data ? coverageOf(data) : null;
    return this.#coverage;
  }

  graph(): SiteGraph | null {
    const motions = this.motions();
    const data = this.#solving.current?.data;
    return data && motions ? { handles: data.siteHandle, edges: data.siteEdges, motions } : null;
  }

  #turnsUnder(motions: Float32Array): Turns {
    const { current } = this.#solving;
    const sites = new Map<string, number>();
    current?.data.siteHandle.forEach((index, site) => {
      const handle = current?.project.handles[index];
      if (handle) sites.set(handle.id, site);
    });
    const automatic = this.#history.present.project.handles.filter(
      (handle) => handle.kind === 'point' && isAutomatic(handle),
    );
    return new Map(
      automatic.map((handle) => {
        const site = sites.get(handle.id);
        // `map` reports the turn from the posed picture to rest, hence the sign.
        const turn =
          site === undefined ? -(this.map(anchor(handle, 'rest'))?.rotation ?? 0) : siteTurn(motions, site);
        // Rounded as in the document, so that pinning changes no digit.
        return [handle.id, rounded(turn)];
      }),
    );
  }

  /** If the solver cannot pose this, for example a bar of no length, the last motions stay. */
  #newest(project: Project): Float32Array | null {
    try {
      return this.#solving.motions(project);
    } catch {
      return this.#motions;
    }
  }

  /** The triangles of the current solution that are checked for folds. */
  get #foldable(): FoldingMesh {
    const data = this.#solving.current?.data;
    this.#folding ??= data ? foldingMesh(data, data.report.samples) : new Uint32Array();
    return this.#folding;
  }

  /** The mesh with its triangles in the drawing order of the current pose. */
  #drawn(data: Skin): Skin {
    const motions = this.motions();
    this.#order ??= new DrawingOrder(data);
    return motions ? { ...data, triangles: this.#order.triangles(motions) } : data;
  }

  #positions(): Float32Array {
    const motions = this.motions();
    const positions = this.#solving.current?.data;
    this.#posed ??= positions
      ? posedPositions(positions, motions, blendOf(this.#history.present.project))
      : new Float32Array();
    return this.#posed;
  }
}
