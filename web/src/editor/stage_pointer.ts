import type { Vec } from '../geometry/vec';

/** A pointer on the stage, at one moment. */
export interface StagePointer {
  /** CSS pixels of the stage. */
  readonly stage: Vec;
  readonly shift: boolean;
  readonly alt: boolean;
  /** Ctrl, or Cmd on a Mac: free of guides. */
  readonly free: boolean;
  /** A finger, not a mouse or pen. */
  readonly coarse: boolean;
}
