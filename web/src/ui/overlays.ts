/** Virtual sites, the cell graph and folds, drawn over the posed picture. */
import { nothing, type SVGTemplateResult, svg } from 'lit';
import { type Camera, toStage } from '../geometry/camera';
import { sitePlace } from '../geometry/skin';
import type { Vec } from '../geometry/vec';
import type { OverlayFlags } from './model';

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

export function foldOverlay(folded: FoldedMesh | null, camera: Camera): SVGTemplateResult | typeof nothing {
  if (!folded) return nothing;
  const { posed, triangles } = folded;
  let path = '';
  triangles.forEach((vertex, at) => {
    const corner: Vec = [posed[2 * vertex] ?? 0, posed[2 * vertex + 1] ?? 0];
    path += `${at % 3 === 0 ? 'M' : 'L'}${text(toStage(camera, corner))}${at % 3 === 2 ? 'Z' : ''}`;
  });
  return outlined('folds', path);
}

function graphPath(graph: SiteGraph, camera: Camera): string {
  let path = '';
  for (let edge = 0; edge + 1 < graph.edges.length; edge += 2) {
    const from = place(graph, camera, graph.edges[edge] ?? 0);
    const to = place(graph, camera, graph.edges[edge + 1] ?? 0);
    path += `M${text(from)}L${text(to)}`;
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
