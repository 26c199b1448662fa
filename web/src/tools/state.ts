/**
 * The interface of tools: a tool is a state that takes presses and returns the next state and effects.
 *
 * States are values without DOM or clock. Each file whose name is a gerund has one. The effects are carried out by the
 * editor.
 */

import type { Document } from '../document/document';
import type { PosedDocument } from '../document/group';
import type { CORNERS_NEEDED, Turns } from '../document/handle';
import type { RingCorner } from '../document/lasso_corners';
import type { LineHandle } from '../document/project';
import type { Box } from '../geometry/box';
import type { Guide, SnappedPlace } from '../geometry/guides';
import type { LocatedPoint, Placement } from '../geometry/place';
import type { Vec } from '../geometry/vec';
import type { Wording } from '../texts/wording';
import type { ToolBrush } from './brush_kinds';

/** A pointer at one moment. */
export interface Press {
  /** Position in the posed picture, image pixels. */
  readonly at: Vec;
  /** The same position in CSS pixels of the stage. */
  readonly stage: Vec;
  readonly shift: boolean;
  readonly alt: boolean;
  /** Free of guides. */
  readonly free: boolean;
}

/** A press by keys at a position, image pixels. */
export const pressAt = (at: Vec): Press => ({ at, stage: at, shift: false, alt: false, free: true });

/** Sizes of the hit areas, image pixels. They depend on the zoom and on the kind of pointer. */
export interface Grips {
  /** Radius of the hit area around a point handle or a corner. */
  readonly handle: number;
  /** Half the width of the hit area of a line. A handle is placed on the picture up to this distance from it. */
  readonly line: number;
  /** Radius of the rotation ring, and half the width of its hit area. */
  readonly ring: number;
  readonly band: number;
  /** Distance that the pointer moves before a click becomes a drag. */
  readonly slop: number;
  /** The visible part of the plane: in view and not covered by a card. */
  readonly view: Box;
}

/** The editor's state for tools. */
export interface ToolContext {
  readonly document: Document;
  readonly grips: Grips;
  readonly turns: Turns;
  /** Handles can only be posed: no press removes one. */
  readonly posesOnly: boolean;
  readonly brush: ToolBrush;
  /** Whether the guard against folds is on. */
  readonly guards: boolean;
  /** The outline of the domain, at rest; null while it is free. Pieces × 2 ends × 2. */
  heldOutline(): ArrayLike<number> | null;
  /**
   * Returns the placement of a point handle: at the point or, close to the domain, at the nearest point of it.
   * Otherwise `null`.
   *
   * @param within How close. Left out: as close as a press may miss a line.
   */
  place(at: Vec, within?: number): Placement | null;
  /**
   * The path of a lasso from its last corner to a place, along edges of the picture. It ends at the edge near the
   * place, or at the first corner itself, and leaves out the last corner. Without corners, it is only its end. It uses
   * no edge of the existing outline. Null while the lasso does not snap to edges. A path that is set, not only shown
   * under the pointer, is precise.
   */
  readonly trace: ((corners: readonly Vec[], to: Vec, precise?: boolean) => readonly Vec[]) | null;
  /** Snaps a place to guides, except to those of the moving handles. */
  snap(at: Vec, moving: readonly string[]): SnappedPlace;
  /**
   * Returns the points of the picture under the corners of a drawing. All are on the layer of the first corner, which
   * another part may cover. Outside, the nearest part is extended.
   */
  layerUnder(corners: readonly Vec[]): readonly LocatedPoint[];
}

/** A bar, a polygon or a lasso that is being drawn. */
export interface Draft {
  readonly kind: keyof typeof CORNERS_NEEDED;
  /** Corners on the posed picture, or on the original for a lasso, image pixels. */
  readonly corners: readonly Vec[];
  /** How many corners each press has set, for a lasso. Otherwise each has set one. */
  readonly strokes?: readonly number[];
  /** The corners of presses to redo, the next press last. A new corner clears them. */
  readonly taken: readonly (readonly Vec[])[];
  /** Position of the corner that a press would set. */
  readonly next: Vec | null;
  /** The places before `next` that a press of a lasso would set too, along edges of the picture. */
  readonly path?: readonly Vec[];
  /** Whether a press would finish the drawing. */
  readonly finishing: boolean;
  /** Whether a lasso cuts a hole. */
  readonly hole?: boolean;
}

export type Effect =
  | { readonly type: 'begin'; readonly label: Wording }
  | ({ readonly type: 'edit' } & PosedDocument)
  | { readonly type: 'commit' }
  | { readonly type: 'bail' }
  | { readonly type: 'select'; readonly ids: readonly string[] }
  | { readonly type: 'box'; readonly box: Box | null }
  /** The guides that the moved place lies on. */
  | { readonly type: 'guides'; readonly guides: readonly Guide[] }
  | { readonly type: 'pan'; readonly by: Vec }
  /** The lens is put on a place of the posed picture. */
  | { readonly type: 'look'; readonly at: Vec }
  /** A place that does not bend, of the posed picture. */
  | { readonly type: 'miss'; readonly at: Vec }
  /** A corner was set or undone. */
  | { readonly type: 'drafted'; readonly draft: Draft | null }
  /** The corner of a drawn ring gets the focus. */
  | { readonly type: 'ring-focus'; readonly corner: RingCorner }
  /** So many handles lay outside of a changed selection, and are gone. */
  | { readonly type: 'left-out'; readonly count: number }
  /** A lasso was closed. */
  | { readonly type: 'lassoed'; readonly ring: readonly Vec[]; readonly hole: boolean }
  /** The drawing of the new handle, which is resumed if the solver rejects the handle. */
  | { readonly type: 'drawn'; readonly draft: Draft; readonly handle: LineHandle };

export interface Outcome {
  readonly next: State;
  readonly effects: readonly Effect[];
}

/** A state implements only the inputs that it handles. Others leave it unchanged. */
export interface State {
  /** The current drawing. A state with a draft lasts from press to press. */
  readonly draft?: Draft;
  /** The press holds the selected handles. */
  readonly holds?: true;
  down?(press: Press, context: ToolContext): Outcome;
  move?(press: Press, context: ToolContext): Outcome;
  up?(press: Press, context: ToolContext): Outcome;
  cancel?(): Outcome;
  /** The pointer moves without a press. `null` if it has left. */
  hover?(press: Press | null, context: ToolContext): Outcome;
  /** Finishes the drawing. */
  finish?(context: ToolContext): Outcome;
  /** Undoes the last corner. */
  back?(): Outcome;
  /** Redoes the corner that was undone last. Present only if there is one. */
  again?(): Outcome;
}

/** Snaps the place of a press. Shift restricts directions instead. */
export const snappedPlace = (
  at: Vec,
  press: Press,
  context: ToolContext,
  moving: readonly string[],
): SnappedPlace => (press.shift || press.free ? { at, guides: [] } : context.snap(at, moving));

export const outcome = (next: State, ...effects: readonly Effect[]): Outcome => ({ next, effects });
