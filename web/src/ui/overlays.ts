/** Cells, virtual sites, the cell graph and folds, drawn over the posed picture. */
import { nothing, type SVGTemplateResult, svg } from 'lit';
import { type Camera, toStage } from '../geometry/camera';
import { sitePlace } from '../geometry/skin';
import type { Vec } from '../geometry/vec';

/** Which overlays are shown. */
export type OverlayFlags = Readonly<
  Record<'mesh' | 'cells' | 'sites' | 'graph' | 'folds' | 'reach' | 'coverage', boolean>
>;

/** The sites of a solution in their current pose. */
export interface SiteGraph {
  /** Sites: index of the site's handle, −1 for a virtual site. */
  readonly handles: Int32Array;
  /** Edges × 2: sites whose cells touch. */
  readonly edges: Uint32Array;
  /** Sites × MOTION_STRIDE. */
  readonly motions: Float32Array;
}

/** Some triangles of the posed mesh. */
export interface FoldedMesh {
  /** Vertices × 2, image pixels. */
  readonly posed: Float32Array;
  /** Triangles × 3. */
  readonly triangles: Uint32Array;
}

type Overlay = SVGTemplateResult | typeof nothing;

const place = (graph: SiteGraph, camera: Camera, site: number): Vec =>
  toStage(camera, sitePlace(graph.motions, site));

export function siteOverlay(graph: SiteGraph | null, camera: Camera, flags: OverlayFlags): SVGTemplateResult {
  return svg`
    ${graph && flags.graph ? outlined('graph', graphPath(graph, camera)) : nothing}
    ${graph && flags.sites ? outlined('sites', sitePath(graph, camera)) : nothing}`;
}

/** Drawn twice, first pale and wider, to be visible on any picture. */
const outlined = (name: string, path: string): SVGTemplateResult =>
  svg`<path class="${name} pale" d=${path}/><path class=${name} d=${path}/>`;

/** @param borders Pieces × 2 ends × 2, image pixels. */
export function cellOverlay(borders: Float32Array | null, camera: Camera): Overlay {
  if (!borders) return nothing;
  return outlined('cells', path(borders.length / 2, 2, through(borders, camera)));
}

export function foldOverlay(folded: FoldedMesh | null, camera: Camera): Overlay {
  if (!folded) return nothing;
  const { posed, triangles } = folded;
  const vertex = through(posed, camera);
  return outlined(
    'folds',
    path(triangles.length, 3, (at) => vertex(triangles[at] ?? 0)),
  );
}

function graphPath(graph: SiteGraph, camera: Camera): string {
  const { edges } = graph;
  return path(edges.length, 2, (at) => place(graph, camera, edges[at] ?? 0));
}

/** The places of an array × 2, image pixels, on the stage. */
const through =
  (places: Float32Array, camera: Camera) =>
  (at: number): Vec =>
    toStage(camera, [places[2 * at] ?? 0, places[2 * at + 1] ?? 0]);

/** A path through so many places, closed and begun anew after each so many of them. */
function path(count: number, each: number, place: (at: number) => Vec): string {
  let path = '';
  for (let at = 0; at < count; at++) {
    path += `${at % each === 0 ? 'M' : 'L'}${text(place(at))}${at % each === each - 1 ? 'Z' : ''}`;
  }
  return path;
}

/** A dot is a line of no length with round caps: one path for all of them. */
function sitePath(graph: SiteGraph, camera: Camera): string {
  let path = '';
  graph.handles.forEach((handle, site) => {
    if (handle < 0) path += `M${text(place(graph, camera, site))}h0`;
  });
  return path;
}

const text = ([x, y]: Vec): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
