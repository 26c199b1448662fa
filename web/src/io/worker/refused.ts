import type { WriteFault } from '../writing';

/** A file that the browser cannot make; the message is for people. */
export class Refused extends Error {
  readonly fault: WriteFault = 'encoder';
}

/** A refusal after which the worker cannot go on, such as a panic of its module. */
export class Broken extends Refused {}
