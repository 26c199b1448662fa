import type { Wording } from '../../texts/wording';
import type { WriteFault } from '../writing';

/** A file that the browser cannot make. */
export class Refused extends Error {
  readonly fault: WriteFault = 'encoder';
  /** Why, for people. */
  readonly reason: Wording;

  constructor(reason: Wording) {
    super(reason.key);
    this.reason = reason;
  }
}

/** A failure after which the worker cannot continue, such as a panic of its module. */
export class Broken extends Refused {}
