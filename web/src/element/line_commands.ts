/** Commands for bars and polygons: adds and removes corners, and finishes a drawing. */
import { handleById, selectedHandles } from '../document/document';
import { edges, isClosed, isLine } from '../document/handle';
import type { LineHandle } from '../document/project';
import { type LinePlace, nearestPlace } from '../geometry/polyline';
import { distance, type Vec } from '../geometry/vec';
import { hit } from '../tools/hit';
import type { Crosshair } from './crosshair';
import type { Focus } from './focus';
import type { HitAreas } from './hit_areas';
import type { Permissions } from './permissions';
import type { Workbench } from './workbench';

export interface LineCommandsHost {
  readonly workbench: Workbench;
  readonly permissions: Permissions;
  readonly areas: HitAreas;
  readonly crosshair: Crosshair;
  readonly focus: Focus;
  /** The drawing or the crosshair has changed. */
  looked(): void;
}

export class LineCommands {
  readonly #host: LineCommandsHost;

  constructor(host: LineCommandsHost) {
    this.#host = host;
  }

  /** The index of the corner in hand, if its bar or polygon alone is selected. */
  get corner(): number | null {
    const { workbench, focus } = this.#host;
    const [only, ...others] = selectedHandles(workbench.editing.document);
    const index = focus.corner && focus.corner.id === only?.id ? focus.corner.index : null;
    if (!only || others.length > 0 || !isLine(only) || index === null) return null;
    return index < only.posed.length ? index : null;
  }

  /** Finishes the current drawing. */
  finish(): void {
    const { workbench, permissions, areas, crosshair, focus } = this.#host;
    const { editing } = workbench;
    if (!permissions.editable) return;
    crosshair.at = null;
    editing.apply(editing.machine.finish(areas.scene));
    this.#host.looked();
    if (!editing.machine.draft) focus.hold(editing.document.selection[0]);
  }

  /**
   * Adds a corner halfway after the focused corner, or else to the only selected handle: at a place on its line, image
   * pixels, or on its longest edge.
   */
  addCorner(at?: Vec): void {
    const { document } = this.#host.workbench.editing;
    const { corner } = this.#host.focus;
    const [only, ...others] = selectedHandles(document);
    const handle = corner ? handleById(document, corner.id) : others.length === 0 ? only : undefined;
    if (!handle || !isLine(handle)) return;
    const lengths = edges(handle).map(([a, b]) => distance(a, b));
    const longest = lengths.indexOf(Math.max(...lengths));
    const edge = corner ? Math.min(corner.index, lengths.length - 1) : longest;
    const place = at && !corner ? this.#placeOn(handle, at) : null;
    this.#addCorner(handle, place ?? { edge, fraction: 0.5 });
  }

  /** Removes the focused corner and focuses the one before it. */
  removeCorner(): void {
    const { corner } = this.#host.focus;
    const handle = corner && handleById(this.#host.workbench.editing.document, corner.id);
    if (handle && isLine(handle)) this.#removeCorner(handle, corner.index);
  }

  /** Removes the corner at a place of the picture, or else adds one to the line there. */
  toggleCorner(at: Vec): void {
    const { areas, workbench } = this.#host;
    const under = hit(areas.scene, at, false);
    const handle = under && handleById(workbench.editing.document, under.id);
    if (!handle || !isLine(handle)) return;
    if (under.part === 'corner') this.#removeCorner(handle, under.index);
    const place = under.part === 'handle' ? this.#placeOn(handle, at) : null;
    if (place) this.#addCorner(handle, place);
  }

  /** The place of a line within reach, if there is one. */
  #placeOn({ posed, kind }: LineHandle, at: Vec): LinePlace | null {
    const place = nearestPlace(posed, isClosed(kind), at);
    return place.distance <= this.#host.areas.grips.line ? place : null;
  }

  #addCorner(handle: LineHandle, at: LinePlace): void {
    const { workbench, focus } = this.#host;
    focus.hold(handle.id, workbench.commands.addCorner(handle, at));
  }

  #removeCorner(handle: LineHandle, index: number): void {
    const { workbench, focus } = this.#host;
    const before = workbench.commands.removeCorner(handle, index);
    if (before !== null) focus.hold(handle.id, before);
  }
}
