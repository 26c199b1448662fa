/** The connection of a warper to its solver. All calls can be cancelled. */
import { Drawing } from '../compute/drawing';
import type { Link } from '../compute/link';
import {
  type DrawingOptions,
  type Messages,
  type Name,
  needsLater,
  type Points,
  type PosedRequest,
} from '../compute/messages';
import type { SolutionData } from '../compute/solution';
import { C2WarpError, ENGINE } from '../error';
import type { SolveOptions } from './types';

const DISPOSED = 'The warper was disposed.';
const PAIRS = 'Expected the points as a Float64Array of x, y pairs.';

/** Points per request. The solver checks for cancellation between requests. */
const BATCH = 2 ** 15;

/** The names of requests about points. */
type PointName = 'map' | 'inverse' | 'weights' | 'distances';

export class Solver {
  readonly #link: Link;
  #disposed = false;
  /** Ends with the last solve. */
  #turn: Promise<unknown> = Promise.resolve();

  constructor(link: Link) {
    this.#link = link;
  }

  /** Solves after all solves that were requested earlier. */
  solve(project: string, options: SolveOptions): Promise<SolutionData> {
    const before = this.#turn;
    const solved = this.#solveAfter(before, project, options);
    this.#turn = Promise.allSettled([before, solved]);
    return solved;
  }

  async #solveAfter(
    before: Promise<unknown>,
    project: string,
    { signal, onProgress }: SolveOptions,
  ): Promise<SolutionData> {
    await cancellable(before, signal);
    this.#check(signal);
    const solved = this.#link.send('solve', { project }, onProgress);
    return cancellable(solved, signal, () => {
      this.#link.abandon('solve');
      this.#link.send('stop', null).catch(() => {});
    });
  }

  async ask<N extends 'picture' | 'posed-mesh' | 'next-pose' | 'clip-poses' | 'path' | 'study' | PointName>(
    name: N,
    body: Messages[N][0],
    signal?: AbortSignal,
  ): Promise<Messages[N][1]> {
    this.#check(signal);
    return cancellable(this.#sent(name, body), signal);
  }

  async #sent<N extends Name>(name: N, body: Messages[N][0]): Promise<Messages[N][1]> {
    if (needsLater(name)) await this.#link.extend();
    return this.#link.send(name, body);
  }

  /** Queries points in batches. */
  async *batches<N extends PointName>(
    name: N,
    points: Float64Array,
    bodyOf: (batch: Points) => Messages[N][0],
    signal?: AbortSignal,
  ): AsyncGenerator<Messages[N][1]> {
    if (!(points instanceof Float64Array) || points.length % 2 !== 0) throw new C2WarpError('points', PAIRS);
    let from = 0;
    do {
      yield await this.ask(name, bodyOf(points.slice(from, from + 2 * BATCH)), signal);
      from += 2 * BATCH;
    } while (from < points.length);
  }

  /** Prepares to draw. The caller must take all bands or release the drawing. */
  async draw(posed: PosedRequest, options: DrawingOptions, signal?: AbortSignal): Promise<Drawing> {
    this.#check(signal);
    const size = this.#sent('draw', { ...posed, ...options });
    const drawing = size.then((size) => new Drawing(this.#link, size, () => true));
    return cancellable(drawing, signal, () => void drawing.then((late) => late.release()).catch(() => {}));
  }

  dispose(): void {
    this.#disposed = true;
    this.#link.dispose();
  }

  #check(signal: AbortSignal | undefined): void {
    signal?.throwIfAborted();
    if (this.#disposed) throw new C2WarpError(ENGINE, DISPOSED);
  }
}

/** The answer, unless the signal is aborted first. */
function cancellable<T>(answer: Promise<T>, signal: AbortSignal | undefined, cancel = () => {}): Promise<T> {
  if (!signal) return answer;
  return new Promise((resolve, reject) => {
    const abort = () => {
      reject(signal.reason);
      cancel();
    };
    signal.addEventListener('abort', abort, { once: true });
    answer.then(resolve, reject).finally(() => signal.removeEventListener('abort', abort));
  });
}
