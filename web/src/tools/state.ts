/**
 * How a tool speaks: it is a state that takes presses and answers with the next state and effects.
 *
 * States are values without DOM or clock; each file named in a gerund holds one. `machine.ts` keeps the current one,
 * the editor carries out the effects.
 */

import type { Document } from '../document/document';
import type { Turns } from '../document/handle';
import type { LineHandle } from '../document/project';
import type { Box } from '../geometry/box';
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

/** How far the controls reach, in image pixels: it depends on the zoom and on finger or mouse. */
export interface Grips {
  /** Radius around a handle's place or corner that takes hold of it. */
  readonly handle: number;
  /** How far beside its line a bar is taken hold of. */
  readonly line: number;
  /** Radius of the rotation ring, and half the width of the band that takes hold of it. */
  readonly ring: number;
  readonly band: number;
  /** How far a pointer may slip before a click becomes a drag. */
  readonly slop: number;
}

/** Where a new handle would go: its rest place and the motion that the picture has there now. */
export interface Placement {
  readonly rest: Vec;
  readonly rotation: number;
  readonly scale: number;
}

/** What a tool can see. */
export interface Scene {
  readonly document: Document;
  readonly grips: Grips;
  readonly turns: Turns;
  /** The picture under a place, or null where there is none. */
  place(at: Vec): Placement | null;
  /** The same, and beside the picture as if it went on from its nearest part. */
  placeNear(at: Vec): Placement;
}

/** A bar or polygon that is being drawn. */
export interface Draft {
  readonly kind: LineHandle['kind'];
  /** Where its corners are, on the posed picture. */
  readonly corners: readonly Vec[];
  /** Corners that were taken back, the last one last, until another is set. */
  readonly taken: readonly Vec[];
  /** Where the pointer would put the next. */
  readonly next: Vec | null;
  /** A press there would finish it. */
  readonly finishing: boolean;
}

export type Effect =
  | { readonly type: 'begin'; readonly label: string }
  | { readonly type: 'edit'; readonly document: Document }
  | { readonly type: 'commit' }
  | { readonly type: 'bail' }
  | { readonly type: 'select'; readonly ids: readonly string[] }
  | { readonly type: 'box'; readonly box: Box | null }
  | { readonly type: 'pan'; readonly by: Vec }
  | { readonly type: 'miss'; readonly at: Vec }
  /** A corner was set or taken back. */
  | { readonly type: 'drafted'; readonly draft: Draft | null }
  /** The handle just committed was drawn like this: should the solver refuse it, the drawing comes back. */
  | { readonly type: 'drawn'; readonly draft: Draft; readonly handle: LineHandle };

export interface Outcome {
  readonly next: State;
  readonly effects: readonly Effect[];
}

/** A state answers what it cares about; anything else leaves it as it is. */
export interface State {
  /** What is being drawn. A state with a draft lasts from press to press. */
  readonly draft?: Draft;
  down?(press: Press, scene: Scene): Outcome;
  move?(press: Press, scene: Scene): Outcome;
  up?(press: Press, scene: Scene): Outcome;
  cancel?(): Outcome;
  /** The pointer goes by without a press; null: it has left. */
  hover?(press: Press | null, scene: Scene): Outcome;
  /** The drawing is done. */
  finish?(scene: Scene): Outcome;
  /** Takes the last corner back. */
  back?(): Outcome;
  /** Sets the corner again that was taken back last; there where one was. */
  again?(): Outcome;
}

export const outcome = (next: State, ...effects: readonly Effect[]): Outcome => ({ next, effects });
