/** Cells, virtual sites, the cell graph and creases, drawn over the posed picture. */

import { nothing, type SVGTemplateResult, svg } from 'lit-html';
import type { CreasedMesh, SiteGraph } from '../editor/deformation';
import type { OverlayFlags } from '../editor/overlays';
import { type Camera, toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';

type Overlay = SVGTemplateResult | typeof nothing;

export function siteOverlay(graph: SiteGraph | null, camera: Camera, flags: OverlayFlags): SVGTemplateResult {
  return svg`
    ${graph && flags.graph ? outlined('graph', graphPath(graph, camera)) : nothing}
    ${graph && flags.sites ? outlined('sites', sitePath(graph, camera)) : nothing}`;
}

/** Drawn twice, first pale and wider, to be visible on any picture. */
const outlined = (name: string, path: string): SVGTemplateResult =>
  svg`<path class="${name} pale" d=${path}/><path class=${name} d=${path}/>`;

/** @param borders Pieces × 2 ends × 2, image pixels. */
export const cellOverlay = (borders: Float32Array | null, camera: Camera): Overlay =>
  borders ? outlined('cells', cellPath(borders, camera)) : nothing;

/** @param borders as for {@link cellOverlay}. */
export const cellPath = (borders: Float32Array | null, camera: Camera): string =>
  borders ? path(borders.length / 2, 2, through(borders, camera)) : '';

/** @param outline Pieces × 2 ends × 2, image pixels. */
export function outlineOverlay(outline: Float32Array | null, camera: Camera): Overlay {
  if (!outline) return nothing;
  return outlined('outline', path(outline.length / 2, 2, through(outline, camera)));
}

/** @param outline as for {@link outlineOverlay}. */
export const selectionOverlay = (outline: Float32Array | null, camera: Camera): Overlay =>
  outline ? outlined('selection', path(outline.length / 2, 2, through(outline, camera))) : nothing;

/** @param outline as for {@link outlineOverlay}. */
export const onionOverlay = (outline: Float32Array, camera: Camera): SVGTemplateResult =>
  outlined('onion-skin', path(outline.length / 2, 2, through(outline, camera)));

export function creaseOverlay(creased: CreasedMesh | null, camera: Camera): Overlay {
  if (!creased) return nothing;
  const { posed, triangles } = creased;
  const vertex = through(posed, camera);
  return outlined(
    'creases',
    path(triangles.length, 3, (at) => vertex(triangles[at] ?? 0)),
  );
}

function graphPath(graph: SiteGraph, camera: Camera): string {
  const { edges } = graph;
  const place = through(graph.places, camera);
  return path(edges.length, 2, (at) => place(edges[at] ?? 0));
}

/** The places of an array × 2, image pixels, on the stage. */
const through =
  (places: Float32Array, camera: Camera) =>
  (at: number): Vec =>
    toStage(camera, [places[2 * at] ?? 0, places[2 * at + 1] ?? 0]);

/** A path through `count` places, closed after each group of `each` places. */
function path(count: number, each: number, place: (at: number) => Vec): string {
  let path = '';
  for (let at = 0; at < count; at++) {
    path += `${at % each === 0 ? 'M' : 'L'}${text(place(at))}${at % each === each - 1 ? 'Z' : ''}`;
  }
  return path;
}

/** One path for all sites: a dot is a line of length 0 with round caps. */
function sitePath(graph: SiteGraph, camera: Camera): string {
  const place = through(graph.places, camera);
  let path = '';
  graph.handles.forEach((handle, site) => {
    if (handle < 0) path += `M${text(place(site))}h0`;
  });
  return path;
}

const text = ([x, y]: Vec): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
