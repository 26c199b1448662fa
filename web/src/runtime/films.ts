/** Exports clips as films. All but the state of the export is loaded when it is first needed. */
import type { EditorEffect } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import { asError, isAbort } from '../error';
import { notLoaded } from './lazy_view';
import type { Solver } from './solver';

type Effect<T extends EditorEffect['type']> = Extract<EditorEffect, { readonly type: T }>;

const load = () =>
  import('./filming').catch((cause: unknown) => {
    throw notLoaded(cause);
  });

export class Films {
  readonly #dispatch: Dispatch;
  readonly #solver: Solver;
  #exporting: AbortController | null = null;

  constructor(dispatch: Dispatch, solver: Solver) {
    this.#dispatch = dispatch;
    this.#solver = solver;
  }

  async export(order: Effect<'export-film'>, pixelated: boolean): Promise<void> {
    const controller = new AbortController();
    this.#exporting = controller;
    const { signal } = controller;
    try {
      const { exportedFilm } = await load();
      const saved = await exportedFilm(this.#solver, order, pixelated, {
        signal,
        onProgress: (fraction, left) =>
          this.#dispatch({ type: 'export-progressed', fraction, ...(left === null ? {} : { left }) }),
      });
      this.#dispatch({ type: 'export-ended', saved, error: null });
    } catch (thrown) {
      const error = asError(thrown);
      this.#dispatch({ type: 'export-ended', saved: null, error: isAbort(error) ? null : error });
    } finally {
      controller.abort();
    }
  }

  cancel(): void {
    this.#exporting?.abort();
  }

  async findCodecs({ width, height, rate }: Effect<'find-codecs'>): Promise<void> {
    try {
      const { videoCodecs } = await load();
      this.#dispatch({ type: 'codecs-found', codecs: await videoCodecs({ width, height, rate }) });
    } catch (error) {
      this.#dispatch({ type: 'error-reported', error: asError(error) });
    }
  }

  dispose(): void {
    this.cancel();
  }
}
