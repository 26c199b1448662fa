/**
 * The interface of tools: a tool is a state that takes presses and returns the next state and effects.
 *
 * States are values without DOM or clock; each file named with a gerund holds one. `machine.ts` holds the current
 * state, and the editor carries out the effects.
 */

import type { Document } from '../document/document';
import type { PosedDocument } from '../document/group';
import type { CORNERS_NEEDED, Turns } from '../document/handle';
import type { LineHandle } from '../document/project';
import type { Box } from '../geometry/box';
import type { LocatedPoint, Placement } from '../geometry/place';
import type { Vec } from '../geometry/vec';

/** A pointer at one moment. */
export interface Press {
  /** In image pixels of the posed picture. */
  readonly at: Vec;
  /** The same place in CSS pixels of the stage. */
  readonly stage: Vec;
  readonly shift: boolean;
  readonly alt: boolean;
}

/** A press by keys at a place, image pixels. */
export const pressAt = (at: Vec): Press => ({ at, stage: at, shift: false, alt: false });

/** Sizes of the hit areas, image pixels: they depend on the zoom and on finger or mouse. */
export interface Grips {
  /** Radius of the hit area around a point handle or a corner. */
  readonly handle: number;
  /** How far beside its line a bar or polygon can be pressed, and beside the picture a handle placed on it. */
  readonly line: number;
  /** Radius of the rotation ring, and half the width of its hit area. */
  readonly ring: number;
  readonly band: number;
  /** How far the pointer may move before a click becomes a drag. */
  readonly slop: number;
  /** The part of the picture's plane that is in view and that no card covers. */
  readonly view: Box;
}

/** The editor's state as seen by tools. */
export interface ToolContext {
  readonly document: Document;
  readonly grips: Grips;
  readonly turns: Turns;
  /** Where on the picture a point handle goes: there or, close beside what bends, the nearest place on it; else null. */
  place(at: Vec): Placement | null;
  /** What lies at a point; beside the picture as if its nearest part continued there. */
  placeNear(at: Vec): LocatedPoint;
}

/** A bar, a polygon or a lasso that is being drawn. */
export interface Draft {
  readonly kind: keyof typeof CORNERS_NEEDED;
  /** Corners on the posed picture, those of a lasso on the original: image pixels. */
  readonly corners: readonly Vec[];
  /** Corners to redo, the next one last; emptied when another corner is set. */
  readonly taken: readonly Vec[];
  /** Where a press would set the next corner. */
  readonly next: Vec | null;
  /** A press there would finish the drawing. */
  readonly finishing: boolean;
  /** Of a lasso: it cuts a hole. */
  readonly hole?: boolean;
}

export type Effect =
  | { readonly type: 'begin'; readonly label: string }
  | ({ readonly type: 'edit' } & PosedDocument)
  | { readonly type: 'commit' }
  | { readonly type: 'bail' }
  | { readonly type: 'select'; readonly ids: readonly string[] }
  | { readonly type: 'box'; readonly box: Box | null }
  | { readonly type: 'pan'; readonly by: Vec }
  | { readonly type: 'miss' }
  /** A corner was set or taken back. */
  | { readonly type: 'drafted'; readonly draft: Draft | null }
  /** A lasso was closed. */
  | { readonly type: 'lassoed'; readonly ring: readonly Vec[]; readonly hole: boolean }
  /** The drawing of the handle just committed, to be resumed if the solver refuses the handle. */
  | { readonly type: 'drawn'; readonly draft: Draft; readonly handle: LineHandle };

export interface Outcome {
  readonly next: State;
  readonly effects: readonly Effect[];
}

/** A state implements only the inputs that it handles; any other leaves it unchanged. */
export interface State {
  /** The current drawing. A state with a draft lasts from press to press. */
  readonly draft?: Draft;
  /** The press has the selected handles in hand. */
  readonly holds?: true;
  down?(press: Press, context: ToolContext): Outcome;
  move?(press: Press, context: ToolContext): Outcome;
  up?(press: Press, context: ToolContext): Outcome;
  cancel?(): Outcome;
  /** The pointer moves without a press; null: it has left. */
  hover?(press: Press | null, context: ToolContext): Outcome;
  /** Finishes the drawing. */
  finish?(context: ToolContext): Outcome;
  /** Takes back the last corner. */
  back?(): Outcome;
  /** Redoes the corner that was taken back last; present only if there is one. */
  again?(): Outcome;
}

export const outcome = (next: State, ...effects: readonly Effect[]): Outcome => ({ next, effects });
