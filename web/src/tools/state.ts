/**
 * How a tool speaks: it is a state that takes presses and answers with the next state and effects.
 *
 * States are values without DOM or clock; each file named in a gerund holds one. `machine.ts` keeps the current one,
 * the editor carries out the effects.
 */

import type { Document } from '../document/document';
import type { Turns } from '../document/handle';
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
  /** Radius around a handle's place that takes hold of it. */
  readonly handle: number;
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
}

export type Effect =
  | { readonly type: 'begin'; readonly label: string }
  | { readonly type: 'edit'; readonly document: Document }
  | { readonly type: 'commit' }
  | { readonly type: 'bail' }
  | { readonly type: 'select'; readonly ids: readonly string[] }
  | { readonly type: 'box'; readonly box: Box | null }
  | { readonly type: 'pan'; readonly by: Vec }
  | { readonly type: 'miss'; readonly at: Vec };

export interface Outcome {
  readonly next: State;
  readonly effects: readonly Effect[];
}

/** A state answers what it cares about; anything else leaves it as it is. */
export interface State {
  down?(press: Press, scene: Scene): Outcome;
  move?(press: Press, scene: Scene): Outcome;
  up?(press: Press, scene: Scene): Outcome;
  cancel?(): Outcome;
}

export const outcome = (next: State, ...effects: readonly Effect[]): Outcome => ({ next, effects });
