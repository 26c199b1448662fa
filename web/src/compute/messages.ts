/** What page and worker say to each other. */
import type { Pixels, SolutionData, Stage } from './solution';

/** Name of a request → what it carries, what answers it. Projects travel as their JSON text. */
export interface Messages {
  /** The picture that all later requests are about. */
  picture: [request: Pixels, response: null];
  /** Is given up, and answered as superseded, when a newer one or another picture arrives. */
  solve: [request: { readonly project: string }, response: SolutionData];
  /** The warped picture at full quality. */
  warp: [request: { readonly project: string; readonly scale: number }, response: Pixels];
}

export type Name = keyof Messages;

/** A request as it is sent; `id` comes back with every reply to it. */
export type Request = {
  [N in Name]: { readonly id: number; readonly name: N; readonly body: Messages[N][0] };
}[Name];

/** What the worker is started with: the compiled module, shared with the page. */
export interface Boot {
  readonly module: WebAssembly.Module;
}

/** An error that crossed from the worker. */
export interface Failure {
  readonly code: string;
  readonly message: string;
  /** Ids of the handles that the message names. */
  readonly handles?: readonly string[];
}

export type Reply =
  | { readonly id: number; readonly kind: 'done'; readonly body: Messages[Name][1] }
  | { readonly id: number; readonly kind: 'progress'; readonly stage: Stage }
  | { readonly id: number; readonly kind: 'failed'; readonly failure: Failure }
  /** The module panicked: the worker is of no more use. */
  | { readonly kind: 'died'; readonly message: string };

/** Code of the failure that answers an overtaken solve. */
export const SUPERSEDED = 'superseded';
