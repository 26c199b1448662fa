/** The posed picture as geometry: the motions that draw it, and what lies where on it. */
import { blendOf } from '../document/bending';
import { anchor, isAutomatic, rounded, type Turns } from '../document/handle';
import type { Project } from '../document/project';
import { posedPositions } from '../geometry/blend';
import { type Box, boxAround, reachesBeyond } from '../geometry/box';
import { DrawingOrder } from '../geometry/drawing_order';
import { type FoldingMesh, foldCount, foldedTriangles, foldingMesh } from '../geometry/folds';
import { type Located, locate, locateNear } from '../geometry/locate';
import { type Skin, siteTurn } from '../geometry/skin';
import type { Vec } from '../geometry/vec';
import type { Placement } from '../tools/state';
import type { FoldedMesh, SiteGraph } from '../ui/overlays';
import type { Workbench } from './workbench';

/** Less of a pixel than this is not missed, nor what rounding takes. */
const SLACK = 0.5;

export class Posing {
  readonly #workbench: Workbench;
  #project: Project | null = null;
  #motions: Float32Array | null = null;
  #posed: Float32Array | null = null;
  #turns: Turns | null = null;
  #folds: number | null = null;
  #folding: FoldingMesh | null = null;
  #order: DrawingOrder | null = null;

  constructor(workbench: Workbench) {
    this.#workbench = workbench;
  }

  /** Another solution: nothing computed before holds. */
  forget(): void {
    this.#project = null;
    this.#motions = null;
    this.#posed = null;
    this.#turns = null;
    this.#folds = null;
    this.#folding = null;
    this.#order = null;
  }

  /** Motions under the pose as it is now; null where there is no solution yet. */
  motions(): Float32Array | null {
    const { project } = this.#workbench.editing;
    if (project !== this.#project) {
      this.#project = project;
      this.#motions = this.#newest(project);
      this.#posed = null;
      this.#turns = null;
      this.#folds = null;
    }
    return this.#motions;
  }

  /** How far automatic handles are turned: by their own motions, or as the picture is where the solution knows none yet. */
  turns(): Turns {
    const motions = this.motions();
    this.#turns ??= motions ? this.#turnsUnder(motions) : new Map();
    return this.#turns;
  }

  /** What lies under a place of the posed picture. Without a solution, the picture as it is. */
  place(at: Vec): Placement | null {
    const { picture, solving } = this.#workbench;
    if (!picture) return null;
    if (solving.current) return locate(this.#drawn(solving.current.data), this.#positions(), at);
    const inside = at[0] >= 0 && at[1] >= 0 && at[0] < picture.width && at[1] < picture.height;
    return inside ? { rest: at, rotation: 0, scale: 1 } : null;
  }

  /** The same, and beside the picture as if it went on there. */
  placeNear(at: Vec): Placement {
    const { current } = this.#workbench.solving;
    const near = current && locateNear(this.#drawn(current.data), this.#positions(), at);
    return near ?? { rest: at, rotation: 0, scale: 1 };
  }

  /** How many triangles the pose as it is now turns over. */
  folds(): number {
    this.motions();
    this.#folds ??= foldCount(this.#foldable, this.#positions());
    return this.#folds;
  }

  /** The same for any other pose of the handles, at most one beyond `limit`; infinite where there is no such pose. */
  foldsOf(project: Project, limit: number): number {
    const { solving } = this.#workbench;
    if (!solving.current) return 0;
    try {
      const posed = posedPositions(solving.current.data, solving.motions(project), blendOf(project));
      return foldCount(this.#foldable, posed, limit);
    } catch {
      return Number.POSITIVE_INFINITY;
    }
  }

  /** The triangles that have turned over. */
  folded(): FoldedMesh | null {
    if (this.folds() === 0) return null;
    const posed = this.#positions();
    return { posed, triangles: foldedTriangles(this.#foldable, posed) };
  }

  /** The least box around the posed picture, image pixels; null where there is no solution yet. What surrounds the rim does not count. */
  bounds(): Box | null {
    const { current } = this.#workbench.solving;
    return current && boxAround(this.#positions(), current.data.report.samples);
  }

  /** Whether something of the posed picture lies beyond the picture's own rectangle. */
  beyond(): boolean {
    const { picture } = this.#workbench;
    const bounds = this.bounds();
    if (!picture || !bounds) return false;
    return reachesBeyond(bounds, { min: [0, 0], max: [picture.width, picture.height] }, SLACK);
  }

  /** Where a point of the original goes; null outside what is warped. */
  map(rest: Vec): Located | null {
    const { current } = this.#workbench.solving;
    if (!current) return null;
    const inverse = { ...current.data, positions: this.#positions() };
    return locate(inverse, current.data.positions, rest);
  }

  graph(): SiteGraph | null {
    const motions = this.motions();
    const data = this.#workbench.solving.current?.data;
    return data && motions ? { handles: data.siteHandle, edges: data.siteEdges, motions } : null;
  }

  #turnsUnder(motions: Float32Array): Turns {
    const { editing, solving } = this.#workbench;
    const sites = new Map<string, number>();
    solving.current?.data.siteHandle.forEach((index, site) => {
      const handle = solving.current?.project.handles[index];
      if (handle) sites.set(handle.id, site);
    });
    const automatic = editing.project.handles.filter(
      (handle) => handle.kind === 'point' && isAutomatic(handle),
    );
    return new Map(
      automatic.map((handle) => {
        const site = sites.get(handle.id);
        // The map goes from the posed picture to rest: its turn is the other way round.
        const turn =
          site === undefined ? -(this.map(anchor(handle, 'rest'))?.rotation ?? 0) : siteTurn(motions, site);
        // As it is kept when it is pinned, so that pinning changes no digit.
        return [handle.id, rounded(turn)];
      }),
    );
  }

  /** A pose that is none, such as a bar drawn together to one spot, leaves the picture as it was. */
  #newest(project: Project): Float32Array | null {
    try {
      return this.#workbench.solving.motions(project);
    } catch {
      return this.#motions;
    }
  }

  /** What can fold of the solution shown. */
  get #foldable(): FoldingMesh {
    const data = this.#workbench.solving.current?.data;
    this.#folding ??= data ? foldingMesh(data, data.report.samples) : new Uint32Array();
    return this.#folding;
  }

  /** The mesh with its triangles as they are drawn under the pose as it is now. */
  #drawn(data: Skin): Skin {
    const motions = this.motions();
    this.#order ??= new DrawingOrder(data);
    return motions ? { ...data, triangles: this.#order.triangles(motions) } : data;
  }

  #positions(): Float32Array {
    const motions = this.motions();
    const positions = this.#workbench.solving.current?.data;
    this.#posed ??= positions
      ? posedPositions(positions, motions, blendOf(this.#workbench.editing.project))
      : new Float32Array();
    return this.#posed;
  }
}
